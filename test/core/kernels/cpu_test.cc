#include "core/kernels/cpu.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace place_memory::core {
namespace {

TEST(InstructionSets, ThePortableOneIsThereAndTheOthersRise) {
  const auto& sets = instructionSets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front(), InstructionSet::kPortable);
  for (std::size_t i = 1; i < sets.size(); ++i) EXPECT_LT(sets[i - 1], sets[i]);
}

TEST(InstructionSets, EachIsKnownByItsName) {
  for (const InstructionSet set : instructionSets()) {
    EXPECT_EQ(instructionSetNamed(nameOf(set)), set);
  }
}

TEST(InstructionSets, WithoutANameTheFastestIsMeant) {
  EXPECT_EQ(instructionSetNamed(""), instructionSets().back());
}

TEST(InstructionSets, AnotherNameIsRefusedWithThePossibleOnes) {
  for (const char* name : {"sse9", "AVX2", "portable ", "0"}) {
    try {
      instructionSetNamed(name);
      ADD_FAILURE() << name << " was taken";
    } catch (const std::invalid_argument& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("PLACE_MEMORY_ISA is '" + std::string(name) + "'"), std::string::npos);
      for (const InstructionSet set : instructionSets()) {
        EXPECT_NE(what.find(nameOf(set)), std::string::npos) << what;
      }
    }
  }
}

TEST(InstructionSets, OneThatThisProcessorLacksIsRefused) {
  const bool is_arm = instructionSets().back() == InstructionSet::kNeon;
  EXPECT_THROW(instructionSetNamed(is_arm ? "avx2" : "neon"), std::invalid_argument);
}

TEST(ChosenKernel, IsTheLastThatTheChosenSetAllows) {
  const auto last = static_cast<InstructionSet>(static_cast<int>(chosenInstructionSet()) + 1);
  const std::vector<KernelVariant<int>> variants{
      {InstructionSet::kPortable, 1}, {chosenInstructionSet(), 2}, {last, 3}};
  EXPECT_EQ(chosenKernel(variants), 2);
}

}  // namespace
}  // namespace place_memory::core
