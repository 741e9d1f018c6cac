// What Barrido uses of oneTBB, on plain std::thread and std::mutex, for the preset tsan alone.
// ThreadSanitizer has to see how threads hand work to each other; in Debian's libtbb.so it cannot, so that
// with it every result of a loop looks like a race, and suppressions for that would hide the project's own.
// The promises about order are oneTBB's: pieces of a loop run in any order on several threads, and all before
// it returns.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace tbb {

class global_control {
 public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t value) : value_(value) {
    const std::lock_guard lock(mutex());
    values().insert(value_);
  }
  ~global_control() {
    const std::lock_guard lock(mutex());
    values().erase(values().find(value_));
  }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

  /// Four where nothing else is asked for, so that there are threads to race on a machine with one processor.
  static std::size_t active_value(parameter) {
    const std::lock_guard lock(mutex());
    return values().empty() ? 4 : *values().begin();
  }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  static std::multiset<std::size_t>& values() {
    static std::multiset<std::size_t> instance;
    return instance;
  }
  std::size_t value_;
};

namespace standin {

/// The first exception of several threads.
class FirstError {
 public:
  template <class Work>
  bool guard(const Work& work) {
    try {
      work();
      return true;
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      return false;
    }
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
};

/// Loops inside loops run on the thread they are met by.
inline thread_local bool inside_loop = false;

/// work() on several threads; returns when all have.
template <class Work>
void on_threads(std::size_t most, const Work& work) {
  const std::size_t count =
      std::min(most, global_control::active_value(global_control::max_allowed_parallelism));
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < count; ++i) others.emplace_back([&work] { work(); });
  work();
  for (std::thread& other : others) other.join();
}

/// work(0) … work(count − 1).
template <class Work>
void for_each_piece(std::size_t count, const Work& work) {
  if (inside_loop || count < 2) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next = 0;
  FirstError error;
  on_threads(count, [&] {
    inside_loop = true;
    for (std::size_t i = next++; i < count; i = next++) {
      if (!error.guard([&] { work(i); })) next = count;
    }
    inside_loop = false;
  });
  error.rethrow();
}

}  // namespace standin

template <class Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, std::size_t grain = 1) : begin_(begin), end_(end), grain_(grain) {}
  Value begin() const { return begin_; }
  Value end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

  std::size_t pieces() const { return end_ > begin_ ? (size() + grain_ - 1) / grain_ : 0; }
  blocked_range piece(std::size_t i) const {
    const Value first = begin_ + static_cast<Value>(i * grain_);
    return {first, first + static_cast<Value>(std::min(grain_, static_cast<std::size_t>(end_ - first))),
            grain_};
  }

 private:
  Value begin_, end_;
  std::size_t grain_;
};

struct simple_partitioner {};

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  standin::for_each_piece(range.pieces(), [&](std::size_t i) { body(range.piece(i)); });
}

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
  const std::size_t count = last > first ? static_cast<std::size_t>(last - first) : 0;
  standin::for_each_piece(count,
                          [&](std::size_t i) { body(static_cast<Index>(first + static_cast<Index>(i))); });
}

template <class... Works>
void parallel_invoke(const Works&... works) {
  standin::FirstError error;
  std::vector<std::thread> threads;
  (threads.emplace_back([&] { error.guard(works); }), ...);
  for (std::thread& thread : threads) thread.join();
  error.rethrow();
}

template <class Range, class Value, class Body, class Join>
Value parallel_reduce(const Range& range, const Value& identity, const Body& body, const Join& join) {
  std::vector<Value> parts(range.pieces(), identity);
  standin::for_each_piece(parts.size(), [&](std::size_t i) { parts[i] = body(range.piece(i), identity); });
  Value result = identity;
  for (const Value& part : parts) result = join(result, part);
  return result;
}

template <class Value>
class enumerable_thread_specific {
 public:
  Value& local() {
    const std::lock_guard lock(mutex_);
    return values_[std::this_thread::get_id()];
  }

  class iterator {
   public:
    explicit iterator(typename std::map<std::thread::id, Value>::iterator at) : at_(at) {}
    Value& operator*() const { return at_->second; }
    iterator& operator++() {
      ++at_;
      return *this;
    }
    bool operator!=(const iterator& other) const { return at_ != other.at_; }

   private:
    typename std::map<std::thread::id, Value>::iterator at_;
  };
  iterator begin() { return iterator(values_.begin()); }
  iterator end() { return iterator(values_.end()); }

 private:
  std::mutex mutex_;
  std::map<std::thread::id, Value> values_;
};

class task_arena {
 public:
  explicit task_arena(int) {}
  template <class Work>
  void execute(const Work& work) {
    work();
  }
};

namespace this_task_arena {
template <class Work>
void isolate(const Work& work) {
  work();
}
}  // namespace this_task_arena

}  // namespace tbb
