#ifndef PLACE_MEMORY_NODE_ANSWER_GUARDED_SERVICE_H
#define PLACE_MEMORY_NODE_ANSWER_GUARDED_SERVICE_H

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <exception>

#include "node/answer/service_status.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Offers a service that answers every request: whatever goes wrong is an answer with a status and
/// a sentence, and ends nothing. `server`, whose member answers, must outlive it.
template <class Server, class Request, class Response>
ros::ServiceServer advertiseGuarded(ros::NodeHandle& node, const char* name, Server* server,
                                    void (Server::*answer)(const Request&, Response&)) {
  const boost::function<bool(Request&, Response&)> callback = [server, answer](Request& request,
                                                                               Response& response) {
    try {
      (server->*answer)(request, response);
    } catch (const core::PlaceMemoryError& error) {
      response = Response();
      response.status = toStatus<Response>(error.reason());
      response.message = error.what();
    } catch (const std::exception& error) {
      response = Response();
      response.status = Response::FAILED;
      response.message = error.what();
    }
    return true;
  };
  return node.advertiseService(name, callback);
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_GUARDED_SERVICE_H
