// Reading of files that a model names. Everything here assumes that the names were chosen by an enemy: only
// regular files in the model's folder or below are ever opened, and sizes are known before memory is taken.
#include "pipeline/files/bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "pipeline/files/descriptor.h"

namespace barrido::scene::gltf {
namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t kNotBase64 = 0xff;

constexpr std::array<std::uint8_t, 256> make_base64_values() {
  std::array<std::uint8_t, 256> values{};
  for (auto& value : values) value = kNotBase64;
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  }
  return values;
}
constexpr std::array<std::uint8_t, 256> kBase64Values = make_base64_values();

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// RFC 3986, section 2.1; a '%' without two hexadecimal digits stands for itself.
std::string percent_decode(std::string_view uri) {
  std::string decoded;
  decoded.reserve(uri.size());
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size()) {
      const int high = hex_digit(uri[i + 1]);
      const int low = hex_digit(uri[i + 2]);
      if (high >= 0 && low >= 0) {
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
        continue;
      }
    }
    decoded += uri[i];
  }
  return decoded;
}

/// Blanks and line ends may stand anywhere (RFC 2045, section 6.8), and any letter may be percent-encoded.
bool is_plain_base64(std::string_view text) {
  return text.find_first_of("% \t\r\n\f") == std::string_view::npos;
}

std::string plain_base64(std::string_view text) {
  std::string plain = percent_decode(text);
  std::erase_if(plain, [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
  return plain;
}

Content decode_base64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return {{}, "the base64 text is cut off"};
  Content content{ByteBlock::allocate(text.size() / 4 * 3 + (text.size() % 4 * 3) / 4), {}};
  std::uint8_t* out = content.block.writable();
  std::uint32_t bits = 0;
  int bit_count = 0;
  std::uint8_t invalid = 0;
  for (const char c : text) {
    const std::uint8_t value = kBase64Values[static_cast<unsigned char>(c)];
    invalid |= value;
    bits = (bits << 6) | (value & 63u);
    bit_count += 6;
    if (bit_count >= 8) {
      bit_count -= 8;
      *out++ = static_cast<std::uint8_t>(bits >> bit_count);
    }
  }
  if (invalid == kNotBase64) content.problem = "the base64 text holds other characters";
  return content;
}

/// "http:", "file:" …: letters up to a colon that comes before any slash (RFC 3986, section 3.1).
bool has_scheme(std::string_view uri) {
  const std::size_t end = uri.find_first_of(":/");
  return end != std::string_view::npos && end > 0 && uri[end] == ':';
}

/// Names of schemes and parameters are the same in capitals (RFC 2397, RFC 3986, section 3.1).
bool is_same_name(std::string_view text, std::string_view lower_case) {
  return std::equal(text.begin(), text.end(), lower_case.begin(), lower_case.end(),
                    [](char c, char lower) { return (c >= 'A' && c <= 'Z' ? c + 32 : c) == lower; });
}

/// ";base64" at the end of what stands before the comma; blanks around it do no harm.
bool ends_with_base64(std::string_view head) {
  const std::size_t last = head.find_last_not_of(' ');
  head = head.substr(0, last + 1);
  const std::size_t semicolon = head.rfind(';');
  if (semicolon == std::string_view::npos) return false;
  const std::size_t first = head.find_first_not_of(' ', semicolon + 1);
  return first != std::string_view::npos && is_same_name(head.substr(first), "base64");
}

bool starts_with_parent(const fs::path& normal) { return !normal.empty() && *normal.begin() == ".."; }

/// Both canonical. The folder itself counts as below: that it is no file is a better answer.
bool is_below(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

std::string open_problem(int error_number) {
  if (error_number == ENOENT || error_number == ENOTDIR) return "no such file";
  if (error_number == ENXIO) return "is not a regular file";  // A socket
  return error_number == EACCES ? "cannot be opened" : std::generic_category().message(error_number);
}

/// False when the file ends before.
bool read_fully(int descriptor, std::uint8_t* out, std::size_t size) {
  while (size > 0) {
    const ssize_t got = ::read(descriptor, out, std::min(size, std::size_t{1} << 30));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    out += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

ByteBlock ByteBlock::allocate(std::size_t size) {
  ByteBlock block;
  block.data_ = std::make_shared<raster::UnclearedArray<std::uint8_t>>(size);
  return block;
}

Content read_regular_file(const fs::path& path, std::uint64_t max_bytes, Budget* budget, Budget::Kind kind) {
  const auto problem = [](std::string text) { return Content{{}, std::move(text)}; };
  // Opened first and looked at then, so that nothing can take the file's place in between; a pipe that nobody
  // writes to would otherwise be waited for.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file.is_open()) return problem(open_problem(errno));
  struct stat facts {};
  if (::fstat(file.get(), &facts) != 0) return problem(std::generic_category().message(errno));
  if (S_ISDIR(facts.st_mode)) return problem("is a folder, not a file");
  if (!S_ISREG(facts.st_mode)) return problem("is not a regular file");
  const auto size = static_cast<std::uint64_t>(facts.st_size);
  if (size > max_bytes) {
    return problem("has " + std::to_string(size) + " bytes; at most " + std::to_string(max_bytes) +
                   " are read");
  }
  if (budget != nullptr) budget->add_file(size, kind, path.string());
  Content content{ByteBlock::allocate(static_cast<std::size_t>(size)), {}};
  if (!read_fully(file.get(), content.block.writable(), content.block.size())) {
    content.problem = "cannot be read to its end";
  }
  return content;
}

Content read_standard_input(std::uint64_t max_bytes, Budget* budget, Budget::Kind kind) {
  constexpr std::size_t kLeastRoom = std::size_t{1} << 16;
  Content content{ByteBlock::allocate(kLeastRoom), {}};
  std::size_t size = 0;
  for (;;) {
    if (size == content.block.size()) content.block.resize(2 * size);
    const ssize_t got = ::read(STDIN_FILENO, content.block.writable() + size, content.block.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return {{}, std::generic_category().message(errno)};
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > max_bytes) return {{}, "at most " + std::to_string(max_bytes) + " bytes are read"};
    if (budget != nullptr) budget->add_file(static_cast<std::uint64_t>(got), kind, "<stdin>");
  }
  content.block.resize(size);
  return content;
}

ResolvedPath resolve_uri(const fs::path& folder, std::string_view uri) {
  const std::string decoded = percent_decode(uri);
  if (decoded.empty()) return {{}, "the URI is empty"};
  if (decoded.find('\0') != std::string::npos) return {{}, "the URI holds a zero byte"};
  if (has_scheme(uri)) return {{}, "only relative paths and data URIs are read"};
  const fs::path relative(decoded);
  if (relative.is_absolute()) return {{}, "the path is absolute"};
  if (starts_with_parent(relative.lexically_normal())) return {{}, "the path leaves the model's folder"};

  std::error_code error;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return {{}, error.message()};
  fs::path file = fs::canonical(root / relative, error);
  if (error) {
    const bool missing = error == std::errc::no_such_file_or_directory;
    return {{}, missing ? std::string("no such file") : error.message()};
  }
  if (!is_below(root, file)) return {{}, "the path leaves the model's folder"};
  return {std::move(file), {}};
}

bool is_data_uri(std::string_view uri) { return is_same_name(uri.substr(0, 5), "data:"); }

Content decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return {{}, "the data URI has no comma"};
  const std::string_view text = uri.substr(comma + 1);
  if (ends_with_base64(uri.substr(0, comma))) {
    return is_plain_base64(text) ? decode_base64(text) : decode_base64(plain_base64(text));
  }
  const std::string decoded = percent_decode(text);
  Content content{ByteBlock::allocate(decoded.size()), {}};
  std::copy(decoded.begin(), decoded.end(), content.block.writable());
  return content;
}

}  // namespace barrido::scene::gltf
