#include "tests/bench/measure.h"

#include <cmath>
#include <cstdio>

namespace barrido::bench {

Measurement measure(const ScenePair& scene, const Options& options, const PeerUse& peer) {
  const std::unique_ptr<Drawer> ours = make_barrido_drawer(scene);
  const std::unique_ptr<Drawer> theirs =
      options.no_peer || !peer.can ? nullptr : make_peer_drawer(scene, peer.states);
  Measurement result;
  ours->draw();
  if (theirs) {
    theirs->draw();
    result.unlike = compare(ours->picture(), theirs->picture());
  }
  Drawer* const drawers[] = {ours.get(), theirs.get()};
  const std::vector<Timing> timings = time_interleaved(drawers, options.harness);
  result.barrido = timings[0];
  if (theirs) result.peer = timings[1];
  return result;
}

double geometric_mean(const std::vector<Measurement>& rows) {
  double logarithms = 0;
  int count = 0;
  for (const Measurement& row : rows) {
    if (!row.peer) continue;
    logarithms += std::log(row.ratio());
    ++count;
  }
  return count == 0 ? 0.0 : std::exp(logarithms / count);
}

void print_header(const Table& table) {
  std::printf("\n%s\n", table.title.c_str());
  std::printf("%-22s %-34s %9s %9s %9s %9s %8s %6s %4s %6s %8s\n", "", "", "median ms", "best ms", "M/s",
              "OSMesa ms", "ratio", "goal", "max", "mean", "far ppm");
}

void print_row(const Measurement& row) {
  std::printf("%-22s %-34s %9.2f %9.2f", row.id.c_str(), row.title.c_str(), row.barrido.median_ms,
              row.barrido.best_ms);
  if (row.millions > 0) {
    std::printf(" %9.*f", row.throughput() < 100 ? 1 : 0, row.throughput());
  } else {
    std::printf(" %9s", "");
  }
  if (row.peer) std::printf(" %9.2f %7.2fx", row.peer->median_ms, row.ratio());
  if (row.peer && row.goal > 0) std::printf(" %5.0fx", row.goal);
  if (row.peer && row.goal <= 0) std::printf(" %6s", "");
  if (row.unlike) std::printf(" %4d %6.3f %8.1f", row.unlike->largest, row.unlike->mean, row.unlike->far_ppm);
  if (row.limit_ms > 0) std::printf("   limit %.2f ms", row.limit_ms);
  std::printf("\n");
  std::fflush(stdout);
}

void print_total(const Table& table) {
  int ratios = 0;
  for (const Measurement& row : table.rows) ratios += row.peer.has_value();
  if (ratios > 1) std::printf("geometric mean of %d ratios: %.2fx\n", ratios, geometric_mean(table.rows));
}

}  // namespace barrido::bench
