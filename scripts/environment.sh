# Sourced by the other scripts: the system's python3 and ROS come before anything of the user's.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly root

if [ -r /opt/ros/noetic/setup.bash ] && [ -z "${ROS_DISTRO:-}" ]; then
  set +u  # ROS's own scripts read variables that are not set
  # shellcheck disable=SC1091
  . /opt/ros/noetic/setup.bash
  set -u
fi
# A python3 of pyenv or conda has neither catkin nor ROS.
export PATH=/usr/bin:$PATH

# use_local_ros <build directory>: this build's package, with ROS on this machine alone, also where
# its host name does not resolve, and leaving nothing in the home directory.
use_local_ros() {
  set +u  # catkin's script reads variables that are not set
  # shellcheck disable=SC1091
  . "$1/devel/setup.bash"
  set -u
  unset ROS_IP
  export ROS_HOSTNAME=localhost
  export ROS_MASTER_URI=http://localhost:${ROS_MASTER_PORT:-11311}
  export ROS_HOME=$1/ros_home
  export ROS_LOG_DIR=$ROS_HOME/log
}

# free_port: prints the usual port of a ROS master, or a free one where that is taken.
free_port() {
  /usr/bin/python3 - <<'PYTHON'
import socket
for port in (11311, 0):
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("", port))
        except OSError:
            continue
        print(probe.getsockname()[1])
        break
PYTHON
}
