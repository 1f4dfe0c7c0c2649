#ifndef PLACE_MEMORY_NODE_ANSWER_SERVICE_STATUS_H
#define PLACE_MEMORY_NODE_ANSWER_SERVICE_STATUS_H

#include <place_memory/Clear.h>
#include <place_memory/Export.h>
#include <place_memory/LearnPlace.h>
#include <place_memory/Load.h>
#include <place_memory/Merge.h>
#include <place_memory/RecognizePlace.h>
#include <place_memory/RemovePlace.h>
#include <place_memory/RenamePlace.h>
#include <place_memory/ReportTraversal.h>
#include <place_memory/Save.h>
#include <place_memory/SetLink.h>
#include <place_memory/Undo.h>

#include <cstdint>

#include "node/answer/kept_scans.h"
#include "place_memory/core/place_memory.h"

/// The status with which each service tells of a refusal.
namespace place_memory::node {

/// Of services that change nothing.
template <class Response>
std::uint8_t toStatus(core::PlaceMemoryError::Reason /*reason*/) {
  return Response::FAILED;
}

/// Here and below: what a change cannot run into is as good as a store that failed, because the map
/// is as it was.
template <>
inline std::uint8_t toStatus<Clear::Response>(core::PlaceMemoryError::Reason /*reason*/) {
  return Clear::Response::STORE_FAILED;
}

template <>
inline std::uint8_t toStatus<LearnPlace::Response>(core::PlaceMemoryError::Reason reason) {
  using Reason = core::PlaceMemoryError::Reason;
  switch (reason) {
    case Reason::kLabelTaken:
      return LearnPlace::Response::LABEL_TAKEN;
    case Reason::kInvalidLabel:
      return LearnPlace::Response::INVALID_LABEL;
    case Reason::kInvalidScan:
      return LearnPlace::Response::INVALID_SCAN;
    case Reason::kWrongCells:
      return LearnPlace::Response::WRONG_CELLS;
    case Reason::kAlreadyLearned:
      return LearnPlace::Response::ALREADY_LEARNED;
    case Reason::kDoubtfulScan:
      return LearnPlace::Response::DOUBTFUL_SCAN;
    case Reason::kNoEcho:
      return LearnPlace::Response::NO_ECHO;
    default:
      return LearnPlace::Response::STORE_FAILED;
  }
}

template <>
inline std::uint8_t toStatus<RecognizePlace::Response>(core::PlaceMemoryError::Reason reason) {
  switch (reason) {
    case core::PlaceMemoryError::Reason::kInvalidScan:
      return RecognizePlace::Response::INVALID_SCAN;
    case core::PlaceMemoryError::Reason::kWrongCells:
      return RecognizePlace::Response::WRONG_CELLS;
    default:
      return RecognizePlace::Response::FAILED;
  }
}

template <>
inline std::uint8_t toStatus<RenamePlace::Response>(core::PlaceMemoryError::Reason reason) {
  using Reason = core::PlaceMemoryError::Reason;
  switch (reason) {
    case Reason::kLabelTaken:
      return RenamePlace::Response::LABEL_TAKEN;
    case Reason::kInvalidLabel:
      return RenamePlace::Response::INVALID_LABEL;
    case Reason::kUnknownPlace:
      return RenamePlace::Response::UNKNOWN_PLACE;
    default:
      return RenamePlace::Response::STORE_FAILED;
  }
}

template <>
inline std::uint8_t toStatus<RemovePlace::Response>(core::PlaceMemoryError::Reason reason) {
  return reason == core::PlaceMemoryError::Reason::kUnknownPlace
             ? RemovePlace::Response::UNKNOWN_PLACE
             : RemovePlace::Response::STORE_FAILED;
}

template <>
inline std::uint8_t toStatus<Save::Response>(core::PlaceMemoryError::Reason /*reason*/) {
  return Save::Response::STORE_FAILED;
}

template <>
inline std::uint8_t toStatus<Export::Response>(core::PlaceMemoryError::Reason /*reason*/) {
  return Export::Response::STORE_FAILED;
}

template <>
inline std::uint8_t toStatus<Load::Response>(core::PlaceMemoryError::Reason reason) {
  return reason == core::PlaceMemoryError::Reason::kOtherStore ? Load::Response::UNREADABLE
                                                               : Load::Response::STORE_FAILED;
}

template <>
inline std::uint8_t toStatus<Merge::Response>(core::PlaceMemoryError::Reason reason) {
  return reason == core::PlaceMemoryError::Reason::kOtherStore ? Merge::Response::UNREADABLE
                                                               : Merge::Response::STORE_FAILED;
}

template <>
inline std::uint8_t toStatus<Undo::Response>(core::PlaceMemoryError::Reason reason) {
  switch (reason) {
    case core::PlaceMemoryError::Reason::kNothingToUndo:
      return Undo::Response::NOTHING;
    case core::PlaceMemoryError::Reason::kCannotUndo:
      return Undo::Response::CHANGED;
    default:
      return Undo::Response::STORE_FAILED;
  }
}

/// Of ReportTraversal and SetLink.
template <class Response>
std::uint8_t toLinkStatus(core::PlaceMemoryError::Reason reason) {
  switch (reason) {
    case core::PlaceMemoryError::Reason::kUnknownPlace:
      return Response::UNKNOWN_PLACE;
    case core::PlaceMemoryError::Reason::kUnknownLink:
      return Response::UNKNOWN_LINK;
    case core::PlaceMemoryError::Reason::kInvalidTraversal:
      return Response::INVALID;
    default:
      return Response::STORE_FAILED;
  }
}

template <>
inline std::uint8_t toStatus<ReportTraversal::Response>(core::PlaceMemoryError::Reason reason) {
  return toLinkStatus<ReportTraversal::Response>(reason);
}

template <>
inline std::uint8_t toStatus<SetLink::Response>(core::PlaceMemoryError::Reason reason) {
  return toLinkStatus<SetLink::Response>(reason);
}

/// Of LearnPlace and RecognizePlace.
template <class Response>
std::uint8_t toStatus(ScanChoice::Problem problem) {
  switch (problem) {
    case ScanChoice::Problem::kNoScan:
      return Response::NO_SCAN;
    case ScanChoice::Problem::kUnknown:
      return Response::UNKNOWN_SCAN;
    case ScanChoice::Problem::kTooOld:
      return Response::SCAN_TOO_OLD;
    case ScanChoice::Problem::kNone:
      break;
  }
  return Response::OK;
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_SERVICE_STATUS_H
