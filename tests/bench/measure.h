// One scene timed with both renderers after their pictures were compared, and the tables that such
// measurements are gathered in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/peer.h"

namespace barrido::bench {

struct Measurement {
  std::string id;     ///< "W1", "1,000,000 triangles"
  std::string title;  ///< What is drawn; may be empty.
  Timing barrido;
  std::optional<Timing> peer;
  std::optional<Unlikeness> unlike;
  double goal = 0;      ///< Of the ratio; 0 where none is set.
  double millions = 0;  ///< Of pixels or triangles a frame; 0: not told.
  std::string unit;     ///< "Mpix/s" or "Mtri/s"
  double limit_ms = 0;  ///< What the machine itself needs; 0: not told.

  double ratio() const { return peer ? peer->median_ms / barrido.median_ms : 0.0; }
  double throughput() const { return millions / barrido.median_ms * 1e3; }
};

struct Table {
  std::string name;   ///< Key in the JSON
  std::string title;  ///< Printed above it
  std::vector<Measurement> rows;
};

/// What is to be known of a scene before the peer draws it.
struct PeerUse {
  bool can = true;  ///< False: it asks for more than the peer has.
  PeerStates states = PeerStates::one;
};

/// Draws `scene` once with each and compares, then times them interleaved. The peer is left out where there
/// is none, where `options` say so, and where it cannot.
Measurement measure(const crosscheck::ScenePair& scene, const Options& options, const PeerUse& peer = {});

/// Of the ratios of the rows that have one; 0 when none has.
double geometric_mean(const std::vector<Measurement>& rows);

void print_header(const Table& table);
void print_row(const Measurement& row);
/// The geometric mean, where several rows have a ratio.
void print_total(const Table& table);

}  // namespace barrido::bench
