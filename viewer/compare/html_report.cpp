#include "viewer/compare/html_report.h"

#include <cerrno>
#include <memory>
#include <system_error>

#include "pipeline/files/error.h"
#include "pipeline/files/write_file.h"
#include "viewer/compare/html_page.h"
#include "viewer/compare/report_pictures.h"
#include "viewer/compare/text_encoding.h"

namespace barrido::compare {
namespace {

namespace fs = std::filesystem;

fs::path made(fs::path folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw scene::InputError(folder.string(), "", "cannot be made: " + error.message());
  return folder;
}

void put(std::FILE* file, const std::string& text, const fs::path& target) {
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size()) {
    throw scene::InputError(target.string(), "",
                            "cannot be written: " + std::generic_category().message(errno));
  }
}

}  // namespace

HtmlReport::HtmlReport(fs::path folder) : folder_(made(std::move(folder))), pictures_(folder_) {}

void HtmlReport::add(const ComparedPair& pair) {
  const ReportPictures pictures = report_pictures(pair);
  const std::string number = std::to_string(shown_.size());
  const auto keep = [&](const Png& png, const char* kind) {
    if (png.empty()) return std::string();
    const std::string name = std::string(kind) + number;
    pictures_.append(picture_element(name, base64(png)));
    return name;
  };
  shown_.push_back({keep(pictures.expected, "expected-"), keep(pictures.actual, "actual-"),
                    keep(pictures.difference, "difference-"), keep(pictures.flip, "flip-"),
                    pictures.amplification, pictures.exposure});
}

void HtmlReport::write(const Run& run) {
  const fs::path target = folder_ / "index.html";
  scene::write_atomically(target, [&](const fs::path& temporary) {
    struct Closer {
      void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Closer> file(std::fopen(temporary.c_str(), "wb"));
    if (!file)
      throw scene::InputError(target.string(), "",
                              "cannot be written: " + std::generic_category().message(errno));
    put(file.get(), page_before_pictures(run), target);
    pictures_.copy_to(file.get());
    put(file.get(), page_after_pictures(run, shown_), target);
    if (std::fclose(file.release()) != 0) {
      throw scene::InputError(target.string(), "",
                              "cannot be written: " + std::generic_category().message(errno));
    }
  });
}

}  // namespace barrido::compare
