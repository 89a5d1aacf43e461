#include <exception>
#include <filesystem>
#include <iostream>

#include "tools/make_scenes/gltf_writing/gltf_writer.h"
#include "tools/make_scenes/scenes/scenes.h"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: make_scenes OUT_DIR\n";
    return 2;
  }
  for (const scenes::Model& model :
       {scenes::make_room(), scenes::make_corridor(), scenes::make_desk(),
        scenes::make_white_room(), scenes::make_plane_and_box(), scenes::make_moving_room(),
        scenes::make_visited_room(), scenes::make_walker(), scenes::make_kitchen(),
        scenes::make_hall(), scenes::make_staircase(), scenes::make_courtyard()}) {
    scenes::write_gltf(model, std::filesystem::path(argv[1]) / model.name);
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "make_scenes: " << error.what() << '\n';
  return 1;
}
