#include <exception>
#include <iostream>

#include "tools/make_room/finish.h"
#include "tools/make_room/gltf_writer.h"
#include "tools/make_room/room.h"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: make_room OUT_DIR\n";
    return 2;
  }
  room::write_gltf(room::make_room(), room::materials(), room::images(), argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "make_room: " << error.what() << '\n';
  return 1;
}
