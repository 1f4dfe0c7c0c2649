#include "tools/child_process.h"

#include <sys/prctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace place_memory::tools {
namespace {

bool isCrash(int signal) {
  return signal == SIGSEGV || signal == SIGABRT || signal == SIGBUS || signal == SIGFPE ||
         signal == SIGILL;
}

int statusOf(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return EXIT_FAILURE;
  }
  return status;
}

}  // namespace

int runInChild(const std::function<int()>& work, const std::string& advice) {
  std::cout.flush();
  std::cerr.flush();
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) return work();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) std::exit(EXIT_FAILURE);
    std::exit(work());
  }
  const int status = statusOf(child);
  if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
  const int signal = WTERMSIG(status);
  if (isCrash(signal) || signal == SIGKILL) {
    std::cerr << "place_memory_bag: ended by signal " << signal << " (" << strsignal(signal)
              << "); " << advice << '\n';
    return EXIT_FAILURE;
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
  return EXIT_FAILURE;
}

}  // namespace place_memory::tools
