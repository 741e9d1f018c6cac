#include "pipeline/files/module_loader.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace barrido::scene {
namespace {

namespace fs = std::filesystem;

/// The folder of the program or shared library that this code is part of; empty when the system does not say.
fs::path own_folder() {
  static const char kPlaceHere = 0;
  Dl_info info{};
  if (::dladdr(&kPlaceHere, &info) == 0 || info.dli_fname == nullptr) {
    return {};
  }
  std::error_code error;
  // For the program itself the loader may only know the name it was called by.
  fs::path file = fs::canonical(info.dli_fname, error);
  if (error) file = fs::canonical("/proc/self/exe", error);
  return error ? fs::path() : file.parent_path();
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  return !path.lexically_relative(folder).empty() && *path.lexically_relative(folder).begin() != "..";
}

std::vector<fs::path> folders_to_search() {
  std::vector<fs::path> folders;
  if (const char* list = std::getenv("BARRIDO_MODULE_PATH"); list != nullptr) {
    std::string_view rest(list);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      if (end > 0) folders.emplace_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  if (const fs::path own = own_folder(); !own.empty()) {
    folders.push_back(own);
    folders.push_back(own / "barrido");
    folders.push_back(own.parent_path() / "lib" / "barrido");
    folders.push_back(own.parent_path() / BARRIDO_INSTALL_LIBDIR / "barrido");
    // Only for programs of the build tree: elsewhere a folder that was deleted long ago could be anybody's.
    if (is_inside(own, BARRIDO_BUILD_DIR)) folders.emplace_back(BARRIDO_MODULE_BUILD_DIR);
  }
  folders.emplace_back(BARRIDO_MODULE_INSTALL_DIR);
  return folders;
}

/// Null, and the reason in `problem`, where the file is no module of this version.
const void* load_from(const fs::path& file, const char* entry_name, std::int32_t version,
                      std::string& problem) {
  void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* reason = ::dlerror();
    problem = "cannot be loaded: " + std::string(reason != nullptr ? reason : file.string());
    return nullptr;
  }
  using Entry = const void* (*)();
  const auto entry = reinterpret_cast<Entry>(::dlsym(handle, entry_name));
  const void* functions = entry != nullptr ? entry() : nullptr;
  if (functions != nullptr && *static_cast<const std::int32_t*>(functions) == version) return functions;
  problem = "is of another version: " + file.string();
  return nullptr;
}

}  // namespace

Module::Module(std::string file, const char* entry, std::int32_t version) : file_(std::move(file)) {
  std::string searched;
  for (const fs::path& folder : folders_to_search()) {
    std::error_code error;
    if (fs::exists(folder / file_, error)) {
      functions_ = load_from(folder / file_, entry, version, problem_);
      return;
    }
    searched += (searched.empty() ? "" : ", ") + folder.string();
  }
  problem_ = "was not found in " + searched;
}

std::string Module::problem(const std::string& purpose) const {
  return purpose + " needs the module " + file_ + ", which " + problem_;
}

}  // namespace barrido::scene
