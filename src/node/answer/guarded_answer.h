#ifndef PLACE_MEMORY_NODE_ANSWER_GUARDED_ANSWER_H
#define PLACE_MEMORY_NODE_ANSWER_GUARDED_ANSWER_H

#include <exception>

#include "node/answer/service_status.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Where use_sim_time is set and /clock is silent.
constexpr char kNoTimeMessage[] =
    "use_sim_time is set, but no time has come on /clock yet: start what publishes it";

/// Whatever goes wrong is an answer, and ends nothing.
template <class Response, class Answer>
void guard(Response& response, const Answer& answer) {
  try {
    answer();
  } catch (const core::PlaceMemoryError& error) {
    response = Response();
    response.status = toStatus<Response>(error.reason());
    response.message = error.what();
  } catch (const std::exception& error) {
    response = Response();
    response.status = Response::FAILED;
    response.message = error.what();
  }
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_GUARDED_ANSWER_H
