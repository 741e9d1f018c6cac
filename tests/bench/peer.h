// What is measured: a renderer that holds one workload's frame ready and draws it again and again. There are
// two, Barrido and OSMesa; the harness knows them by this interface only.
#pragma once

#include <memory>
#include <string>

#include "tests/osmesa/scene_pair.h"

namespace barrido::bench {

class Drawer {
 public:
  virtual ~Drawer() = default;
  /// Draws the whole frame, clear included, and waits until it is finished.
  virtual void draw() = 0;
  /// The frame as last drawn.
  virtual crosscheck::Picture picture() = 0;
};

/// The scene must outlive the drawer.
std::unique_ptr<Drawer> make_barrido_drawer(const crosscheck::ScenePair& scene);

/// How often the peer's state is set: once before all draws, which then differ in their arrays only (and in
/// their programs), or for each.
enum class PeerStates { one, of_each_draw };

/// Null when this program was built without OSMesa. One at a time. OSMesa reads the number of its threads
/// once, from set_peer_threads.
std::unique_ptr<Drawer> make_peer_drawer(const crosscheck::ScenePair& scene, PeerStates states);

/// To be called before the first peer drawer is made. 1: everything on the calling thread; n: n threads
/// rasterize beside the calling one.
void set_peer_threads(int threads);

/// "llvmpipe (LLVM 15.0.6, 512 bits), 4.5 … Mesa 22.3.6", or why there is no peer.
std::string peer_description();

}  // namespace barrido::bench
