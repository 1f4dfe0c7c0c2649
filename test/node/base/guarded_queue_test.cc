#include "node/base/guarded_queue.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <stdexcept>
#include <vector>

namespace place_memory::node {
namespace {

class Call : public ros::CallbackInterface {
 public:
  explicit Call(std::function<void()> what) : what_(std::move(what)) {}
  CallResult call() override {
    what_();
    return Success;
  }

 private:
  std::function<void()> what_;
};

ros::CallbackInterfacePtr callOf(std::function<void()> what) {
  return boost::make_shared<Call>(std::move(what));
}

TEST(GuardedQueue, WhatIsThrownIsToldAndTheNextCallbackHasItsTurn) {
  std::vector<std::string> told;
  GuardedQueue queue("test", [&](const std::string& what) { told.push_back(what); });
  int calls = 0;
  queue.addCallback(callOf([] { throw std::runtime_error("out of dual 32-bit range"); }));
  queue.addCallback(callOf([&] { ++calls; }));
  queue.addCallback(callOf([] { throw 7; }));
  queue.addCallback(callOf([&] { ++calls; }));
  EXPECT_NO_THROW(queue.callAvailable());
  EXPECT_EQ(calls, 2);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0], "out of dual 32-bit range");
  EXPECT_NE(told[1], "");
  EXPECT_TRUE(queue.empty());
}

TEST(GuardedQueue, NothingGetsOutOfTheOneWhoIsTold) {
  GuardedQueue queue("test", [](const std::string&) { throw std::runtime_error("again"); });
  queue.addCallback(callOf([] { throw std::runtime_error("once"); }));
  EXPECT_NO_THROW(queue.callAvailable());
}

TEST(GuardedQueue, ACallbackThatIsRemovedIsNotCalled) {
  GuardedQueue queue("test");
  int calls = 0;
  queue.addCallback(callOf([&] { ++calls; }), 5);
  queue.addCallback(callOf([&] { calls += 10; }), 6);
  queue.removeByID(5);
  queue.callAvailable();
  EXPECT_EQ(calls, 10);
}

}  // namespace
}  // namespace place_memory::node
