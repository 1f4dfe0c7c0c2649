#include "node/answer/answer_words.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using Answer = core::PlaceMemory::Answer;

Answer makeAnswer(core::Verdict verdict) {
  Answer answer;
  answer.recognition.verdict = verdict;
  answer.recognition.matches = {{5, 90.0, {}, 0.6}, {2, 80.0, {}, 0.4}};
  answer.labels = {"e", "b"};
  return answer;
}

bool says(const Answer& answer, const std::string& words) {
  return inWords(answer).find(words) != std::string::npos;
}

TEST(InWords, EachVerdictHasItsSentence) {
  EXPECT_EQ(inWords({}), "not recognised: no place was learned yet");
  EXPECT_EQ(inWords(makeAnswer(core::Verdict::kRecognized)),
            "recognised \"e\" with probability 60 %");
  EXPECT_EQ(inWords(makeAnswer(core::Verdict::kAmbiguous)),
            "ambiguous: the best of 2 places is \"e\" with probability 60 %");
  EXPECT_EQ(inWords(makeAnswer(core::Verdict::kUnknown)),
            "not recognised: the best of 2 places is \"e\" with probability 60 %");
}

TEST(InWords, AScanWithoutAnEchoIsNamedAsTheReason) {
  Answer answer = makeAnswer(core::Verdict::kUnknown);
  answer.recognition.no_echo = true;
  EXPECT_TRUE(says(answer, "not recognised: no echo lies in the scan's grid"));
}

TEST(InWords, WhatBecameOfTheMapIsSaid) {
  Answer answer = makeAnswer(core::Verdict::kRecognized);
  EXPECT_FALSE(says(answer, ";"));
  answer.adapted = true;
  EXPECT_TRUE(says(answer, "the scan was folded into \"e\""));
  answer.joined = 3;
  EXPECT_TRUE(says(answer, "3 places learned before"));
  answer.adapt_problem = "the disk is full";
  EXPECT_TRUE(says(answer, "not folded into \"e\": the disk is full"));
  answer.superseded = true;
  EXPECT_TRUE(says(answer, "overtook"));
}

}  // namespace
}  // namespace place_memory::node
