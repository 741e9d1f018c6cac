// What Highway's dynamic dispatch asks its library for: which instruction sets this processor and operating
// system offer, and the one in use. Defined here so that the library, of which nothing else is needed, is not
// linked. The reason, measured: before main() a static initializer of the library (1.0.3) finds out the
// resolution of its benchmark's timer. An empty program takes 0.75 ms of processor time, 1.6 ms with
// libstdc++ loaded, 7.3 ms with libhwy loaded (medians of 40 runs each); a whole thumbnail takes 8.5 ms.
//
// The alternative tried is to link the library: that costs the 5 to 6 ms in every process, and none of its
// settings prevents it. No archive comes with Debian's package, of which targets.o alone could be linked, and
// this version's headers have no way to do without the library.
#include <hwy/targets.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace hwy {
namespace {

#if HWY_ARCH_X86

// The groups are those of Highway's detect_targets.h, whose kernels are compiled with all of each; whether
// the operating system saves the wide registers is part of what the compiler's function answers.

bool has_sse4() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("aes") &&
         __builtin_cpu_supports("pclmul");
}

/// Two that older compilers' function does not know: F16C is leaf 1, ECX bit 29; LZCNT leaf 0x80000001, ECX
/// bit 5 (AMD64 Architecture Programmer's Manual 3, appendix D).
bool has_f16c_and_lzcnt() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (__get_cpuid(1, &a, &b, &c, &d) == 0 || (c >> 29 & 1) == 0) return false;
  return __get_cpuid(0x80000001u, &a, &b, &c, &d) != 0 && (c >> 5 & 1) != 0;
}

bool has_avx2() {
  return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && has_f16c_and_lzcnt();
}

bool has_avx3() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512bw");
}

std::int64_t detect() {
  std::int64_t targets = HWY_STATIC_TARGET | HWY_EMU128 | HWY_SCALAR;
  if (__builtin_cpu_supports("ssse3")) targets |= HWY_SSSE3;
  if (has_sse4()) targets |= HWY_SSE4;
  if (has_avx2()) targets |= HWY_AVX2;
  if (has_avx3()) targets |= HWY_AVX3;
  return targets;
}

#else

std::int64_t detect() { return HWY_STATIC_TARGET | HWY_EMU128 | HWY_SCALAR; }

#endif

}  // namespace

std::int64_t SupportedTargets() {
  static const std::int64_t targets = detect();
  return targets;
}

ChosenTarget& GetChosenTarget() {
  static ChosenTarget chosen;
  return chosen;
}

/// Reached from Highway's own assertions, which debug builds have.
void Abort(const char* file, int line, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::fprintf(stderr, "%s:%d: ", file, line);
  std::vfprintf(stderr, format, arguments);
  std::fputc('\n', stderr);
  va_end(arguments);
  std::abort();
}

}  // namespace hwy
