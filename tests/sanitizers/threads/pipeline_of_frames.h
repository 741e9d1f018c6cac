// oneTBB's parallel_pipeline for the one shape that Barrido uses: a serial source, a parallel stage, a serial
// sink in the order of the source.
#pragma once

#include "threads.h"

namespace tbb {

class flow_control {
 public:
  void stop() { stopped_ = true; }
  bool is_stopped() const { return stopped_; }

 private:
  bool stopped_ = false;
};

enum class filter_mode { serial_in_order, parallel };

namespace standin {

template <class In, class Out, class Body>
struct Filter {
  Body body;
};
template <class First, class Second>
struct TwoFilters {
  First first;
  Second second;
};
template <class First, class Second, class Third>
struct ThreeFilters {
  First first;
  Second second;
  Third third;
};

template <class A, class B, class C, class BodyA, class BodyB>
auto operator&(Filter<A, B, BodyA> first, Filter<B, C, BodyB> second) {
  return TwoFilters<Filter<A, B, BodyA>, Filter<B, C, BodyB>>{std::move(first), std::move(second)};
}
template <class First, class Second, class In, class Body>
auto operator&(TwoFilters<First, Second> two, Filter<In, void, Body> third) {
  return ThreeFilters<First, Second, Filter<In, void, Body>>{std::move(two.first), std::move(two.second),
                                                             std::move(third)};
}

/// Whose turn it is to deliver.
class Turns {
 public:
  /// False: somebody has failed, and there are no turns any more.
  bool wait_for(std::size_t turn) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return next_ == turn || failed_; });
    return !failed_;
  }
  void end_turn(bool well) {
    {
      const std::lock_guard lock(mutex_);
      ++next_;
      failed_ = failed_ || !well;
    }
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;
  bool failed_ = false;
};

}  // namespace standin

template <class In, class Out, class Body>
standin::Filter<In, Out, Body> make_filter(filter_mode, const Body& body) {
  return {body};
}

template <class Source, class Stage, class Sink>
void parallel_pipeline(std::size_t in_flight, standin::ThreeFilters<Source, Stage, Sink> filters) {
  std::mutex source;
  flow_control control;
  std::size_t drawn = 0;
  standin::Turns turns;
  standin::FirstError error;
  // A thread carries one item through all stages, so there are no more items than threads.
  standin::on_threads(in_flight, [&] {
    for (;;) {
      std::unique_lock lock(source);
      if (control.is_stopped()) return;
      auto item = filters.first.body(control);
      if (control.is_stopped()) return;
      const std::size_t turn = drawn++;
      lock.unlock();
      const bool staged = error.guard([&] { item = filters.second.body(item); });
      if (!turns.wait_for(turn)) return;
      const bool delivered = staged && error.guard([&] { filters.third.body(item); });
      turns.end_turn(delivered);
      if (delivered) continue;
      lock.lock();
      control.stop();
      return;
    }
  });
  error.rethrow();
}

}  // namespace tbb
