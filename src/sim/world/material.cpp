#include "sim/world/material.h"

namespace place_memory::sim {

const MaterialTable& standardMaterials() {
  static const MaterialTable kTable = {
      {"glass", {0.14, 1.0, 0.95}},     {"whiteboard", {0.16, 1.0, 0.95}},
      {"metal", {0.20, 1.0, 0.92}},     {"painted", {0.30, 0.9, 0.85}},
      {"wood", {0.35, 0.8, 0.8}},       {"brick", {0.6, 0.75, 0.5}},
      {"furniture", {0.9, 0.65, 0.35}}, {"cloth", {1.3, 0.35, 0.1}},
  };
  return kTable;
}

}  // namespace place_memory::sim
