#include "text/file_ledger.h"

#include "text/file_path.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <mutex>

namespace raywalk {

namespace fs = std::filesystem;

namespace {

/// Whether the file system treats both as the same name. Only it knows: rules for letter case vary.
bool is_same_name(const fs::path& folder, const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto letter = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 ? std::tolower(byte) : 0x80;
  };
  const auto may_be = [&](char x, char y) { return letter(x) == letter(y); };
  const bool ascii = std::none_of(a.begin(), a.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  if (ascii && !std::equal(a.begin(), a.end(), b.begin(), b.end(), may_be)) return false;
  std::string attempt = (folder / ".raywalk-XXXXXX").string();
  if (::mkdtemp(attempt.data()) == nullptr) return false;
  const std::string first = attempt + "/" + a, second = attempt + "/" + b;
  const int descriptor = ::open(first.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  const bool same = descriptor >= 0 && ::access(second.c_str(), F_OK) == 0;
  if (descriptor >= 0) ::close(descriptor);
  ::unlink(first.c_str());
  ::rmdir(attempt.c_str());
  return same;
}

enum class Use { read, claimed, kept, written };

struct Entry {
  std::string path;
  Use use;
};

struct Book {
  const FileLedger* ledger;
  FileLedger::Notes notes;
  std::vector<Entry> entries{};
  bool has_refused = false;
};

struct Ledgers {
  std::mutex mutex;
  std::vector<Book> open;
};

Ledgers& ledgers() {
  static Ledgers all;
  return all;
}

Error in_use(const std::string& path, const std::string& as, std::string_view is) {
  const std::string which = path == as ? "this file is " : "this is the same file as " + as + ", which is ";
  return {path, 0, 0, "cannot write: " + which + std::string(is), "choose another file name; nothing was lost"};
}

/// Notes `use` of `path` in each ledger, unless it is in use there.
Result<void> note_output(const std::string& path, Use use) {
  const std::lock_guard lock(ledgers().mutex);
  for (Book& book : ledgers().open) {
    if (book.notes == FileLedger::Notes::reading) continue;
    Entry* claim = nullptr;
    for (Entry& entry : book.entries) {
      const bool may_be_claim = use == Use::written && (entry.use == Use::claimed || entry.use == Use::kept);
      if (may_be_claim && entry.path == path)
        claim = &entry;
      else if ((book.has_refused = is_same_file(entry.path, path)))
        return tl::unexpected(
            in_use(path, entry.path,
                   entry.use == Use::read ? "an input of the same command" : "already an output of the same command"));
    }
    if (claim == nullptr)
      book.entries.push_back({path, use});
    else if (claim->use == Use::claimed)
      claim->use = use;
  }
  return {};
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat of_a{}, of_b{};
  const bool has_a = ::stat(a.c_str(), &of_a) == 0, has_b = ::stat(b.c_str(), &of_b) == 0;
  if (has_a != has_b) return false;
  if (has_a) return S_ISREG(of_a.st_mode) && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
  const auto target_a = detail::follow_links(a), target_b = detail::follow_links(b);
  if (!target_a || !target_b) return false;
  std::error_code missing;
  const fs::path folder = detail::folder_of(*target_a);
  return fs::equivalent(folder, detail::folder_of(*target_b), missing) &&
         is_same_name(folder, target_a->filename().string(), target_b->filename().string());
}

std::optional<Error> why_in_use(const std::string& path, const std::vector<std::string>& files, std::string_view is) {
  for (const std::string& file : files)
    if (is_same_file(file, path)) return in_use(path, file, is);
  return std::nullopt;
}

FileLedger::FileLedger(Notes notes) {
  const std::lock_guard lock(ledgers().mutex);
  ledgers().open.push_back({this, notes});
}

void FileLedger::close() {
  const std::lock_guard lock(ledgers().mutex);
  std::erase_if(ledgers().open, [this](const Book& book) { return book.ledger == this; });
}

bool FileLedger::has_refused() const {
  const std::lock_guard lock(ledgers().mutex);
  return std::any_of(ledgers().open.begin(), ledgers().open.end(),
                     [this](const Book& book) { return book.ledger == this && book.has_refused; });
}

std::vector<std::string> FileLedger::files_read() const {
  const std::lock_guard lock(ledgers().mutex);
  std::vector<std::string> files;
  for (const Book& book : ledgers().open)
    for (const Entry& entry : book.entries)
      if (book.ledger == this && entry.use == Use::read) files.push_back(entry.path);
  return files;
}

namespace detail {

void note_read(const std::string& path) {
  const std::lock_guard lock(ledgers().mutex);
  const auto is_known = [&](const Entry& entry) {
    return (entry.use == Use::read || entry.use == Use::kept) && entry.path == path;
  };
  for (Book& book : ledgers().open)
    if (std::none_of(book.entries.begin(), book.entries.end(), is_known)) book.entries.push_back({path, Use::read});
}

Result<void> note_claim(const std::string& path, OutputUse use) {
  return note_output(path, use == OutputUse::kept ? Use::kept : Use::claimed);
}

Result<void> note_written(const std::string& path) { return note_output(path, Use::written); }

}  // namespace detail

}  // namespace raywalk
