#include "endurance/change_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <stdexcept>

#include "core/store/packed_bytes.h"
#include "core/temporary_folder.h"

namespace place_memory {
namespace {

using Size = std::uint32_t;

void append(const std::string& text, std::string& to) {
  core::BytePacker size;
  size.add(static_cast<Size>(text.size()));
  to.append(size.bytes().begin(), size.bytes().end());
  to += text;
}

/// False where not all of it is there.
bool take(const std::string& from, std::size_t& at, std::string& text) {
  core::ByteUnpacker bytes(from.data() + at, from.size() - at);
  const auto size = bytes.take<Size>();
  if (!bytes.good() || bytes.left() < size) return false;
  text = from.substr(at + sizeof(Size), size);
  at += sizeof(Size) + size;
  return true;
}

}  // namespace

ChangeLog::ChangeLog(const std::string& path)
    : file_(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {
  if (file_ < 0) throw std::runtime_error("no log " + path);
}

ChangeLog::~ChangeLog() { close(file_); }

void ChangeLog::say(const Said& said) {
  std::string head{static_cast<char>(said.what), static_cast<char>(said.deed),
                   static_cast<char>(said.client)};
  std::string record;
  for (const std::string& part : {head, said.text, said.new_text, packed(said.map)}) {
    append(part, record);
  }
  std::string whole;
  append(record, whole);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t done = 0; done < whole.size();) {
    const ssize_t written = write(file_, whole.data() + done, whole.size() - done);
    if (written < 0) throw std::runtime_error("the log cannot be written");
    done += static_cast<std::size_t>(written);
  }
}

std::vector<Said> ChangeLog::read(const std::string& path) {
  const std::string whole = readFile(path);
  std::vector<Said> all;
  std::string record;
  for (std::size_t at = 0; take(whole, at, record);) {
    Said said;
    std::string head;
    std::string map;
    std::size_t part = 0;
    if (!take(record, part, head) || !take(record, part, said.text) ||
        !take(record, part, said.new_text) || !take(record, part, map) || head.size() != 3) {
      throw std::runtime_error("the log " + path + " is none");
    }
    said.what = static_cast<Said::What>(head[0]);
    said.deed = static_cast<Deed>(head[1]);
    said.client = static_cast<unsigned char>(head[2]);
    said.map = unpackedMap(map).value();
    all.push_back(std::move(said));
  }
  return all;
}

}  // namespace place_memory
