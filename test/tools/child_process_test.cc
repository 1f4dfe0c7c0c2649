#include "tools/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace place_memory::tools {
namespace {

TEST(RunInChild, ReturnsWhatTheWorkReturns) {
  EXPECT_EQ(runInChild([] { return 3; }, "advice"), 3);
  EXPECT_EQ(runInChild([] { return 0; }, "advice"), 0);
}

TEST(RunInChild, DoesTheWorkInAnotherProcess) {
  const pid_t here = getpid();
  EXPECT_EQ(runInChild([here] { return getpid() == here ? 1 : 0; }, "advice"), 0);
}

TEST(RunInChild, ACrashIsASentence) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGKILL}) {
    testing::internal::CaptureStderr();
    const int status = runInChild(
        [signal] {
          std::signal(signal, SIG_DFL);  // where a sanitizer took it
          return raise(signal);
        },
        "the bag is damaged");
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(status, EXIT_FAILURE);
    EXPECT_NE(text.find("ended by signal " + std::to_string(signal)), std::string::npos) << text;
    EXPECT_NE(text.find("the bag is damaged"), std::string::npos) << text;
  }
}

TEST(RunInChild, WhatStopsTheWorkStopsTheWaitingProcessToo) {
  const pid_t waiting = fork();
  if (waiting == 0) {
    runInChild([] { return raise(SIGTERM); }, "advice");
    _exit(EXIT_SUCCESS);
  }
  int status = 0;
  ASSERT_EQ(waitpid(waiting, &status, 0), waiting);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
}

}  // namespace
}  // namespace place_memory::tools
