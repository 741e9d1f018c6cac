#include "pipeline/pictures/module_loader.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "pipeline/files/error.h"

namespace barrido::scene {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "barrido_oiio.so";

/// The module, or why there is none; exactly one of the two is set.
struct Module {
  const BarridoOiioFunctions* functions = nullptr;
  std::string problem;
};

/// The folder of the program or shared library that this code is part of; empty when the system does not say.
fs::path own_folder() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&openimageio_module), &info) == 0 || info.dli_fname == nullptr) {
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

Module load_from(const fs::path& file) {
  void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* reason = ::dlerror();
    return {nullptr, "cannot be loaded: " + std::string(reason != nullptr ? reason : file.string())};
  }
  using Entry = const BarridoOiioFunctions* (*)();
  const auto entry = reinterpret_cast<Entry>(::dlsym(handle, BARRIDO_OIIO_ENTRY));
  const BarridoOiioFunctions* functions = entry != nullptr ? entry() : nullptr;
  if (functions == nullptr || functions->version != BARRIDO_OIIO_INTERFACE_VERSION) {
    return {nullptr, "is of another version: " + file.string()};
  }
  return {functions, {}};
}

Module find_module() {
  std::string searched;
  for (const fs::path& folder : folders_to_search()) {
    const fs::path file = folder / kModuleName;
    std::error_code error;
    if (fs::exists(file, error)) return load_from(file);
    searched += (searched.empty() ? "" : ", ") + folder.string();
  }
  return {nullptr, "was not found in " + searched};
}

}  // namespace

const BarridoOiioFunctions& openimageio_module(const std::string& name, const FormatTraits& format,
                                               const std::string& purpose) {
  static const Module module = find_module();
  if (module.functions == nullptr) {
    throw InputError(name, "",
                     purpose + " " + std::string(format.name) + " needs the module " + kModuleName +
                         ", which " + module.problem);
  }
  return *module.functions;
}

}  // namespace barrido::scene
