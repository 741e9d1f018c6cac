// Stands in where OSMesa is not installed: there is nothing to measure against.
#include "tests/bench/peer.h"

namespace barrido::bench {

std::unique_ptr<Drawer> make_peer_drawer(const crosscheck::ScenePair&, PeerStates) { return nullptr; }
void set_peer_threads(int) {}
std::string peer_description() { return "none (built without OSMesa)"; }

}  // namespace barrido::bench
