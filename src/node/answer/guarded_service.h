#ifndef PLACE_MEMORY_NODE_ANSWER_GUARDED_SERVICE_H
#define PLACE_MEMORY_NODE_ANSWER_GUARDED_SERVICE_H

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include "node/answer/guarded_answer.h"

namespace place_memory::node {

/// Offers a service that answers every request, also where something goes wrong: see guard().
/// `server`, whose member answers, must outlive it.
template <class Server, class Request, class Response>
ros::ServiceServer advertiseGuarded(ros::NodeHandle& node, const char* name, Server* server,
                                    void (Server::*answer)(const Request&, Response&)) {
  const boost::function<bool(Request&, Response&)> callback = [server, answer](Request& request,
                                                                               Response& response) {
    guard(response, [&] { (server->*answer)(request, response); });
    return true;
  };
  return node.advertiseService(name, callback);
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_GUARDED_SERVICE_H
