#include "io/packed_text.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cstdint>

namespace raywalk {

namespace {

/// What deflate may refer back to from the first letter on; the most frequent last. It is part of what links are
/// written in: a change of a letter here makes links of earlier versions unreadable.
constexpr std::string_view known_words =
    R"("title":"","description":"","translated":["fov":45,"up":[0,0,1],"image":{"width":441,"height":331,"limits":{"depth":5,)"
    R"("threshold":0.01,"render":{"samples":16,"integrator":"whitted","numerics":"naive","epsilon":0.001,"screen":{"cells":21,)"
    R"("distance":2,"background":[0.1,"ambient":0.2,"type":"ellipsoid","type":"cylinder","type":"cone","type":"disk",)"
    R"("type":"box","min":[-"max":["type":"triangle","type":"plane","point":[0,0,-1.2],"normal":[0,0,1],"checker":{)"
    R"("even":[0.95,"odd":[0.35,"size":1.0}"transform":[["translate",["rotate",["scale",[["type":"instance","group":")"
    R"("aperture":0.1,"focus":"shutter":"emission":"type":"directional","direction":["type":"polygon","corners":[[)"
    R"("height":2.4,"shadow":"filtered","dielectric":true,"absorption":[0.,"attenuation":[1,0,0.05],"strength":1.0,)"
    R"("type":"point","position":["camera":{"eye":[-6,0,0],"look_at":[0,0,0],"type":"sphere","centre":[-1.5,0.5,0.0],)"
    R"("radius":0.75,"ior":1.5,"transmission":0.9,"reflection":0.25,"shininess":60,"specular":0.3,"ambient":[0.05,)"
    R"("diffuse":[0.6,0.7,0.8],"material":{"name":"light":{"Light Source":{"object":{"Transparent Sphere":{"Polygon":)"
    R"({"Floor":{"Solid Sphere":{)";

constexpr std::string_view letters_of = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
/// Without a head or a sum, which are bytes in every link.
constexpr int raw_deflate = -15;

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

std::string base64(std::string_view bytes) {
  std::string letters;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char byte : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(byte);
    for (held += 8; held >= 6; held -= 6) letters += letters_of[bits >> (held - 6) & 63U];
  }
  if (held > 0) letters += letters_of[bits << (6 - held) & 63U];
  return letters;
}

/// Nothing if a letter is not one of the 64, or is too much.
bool from_base64(std::string_view letters, std::string& bytes) {
  std::uint32_t bits = 0;
  int held = 0;
  for (const char letter : letters) {
    const std::size_t value = letters_of.find(letter);
    if (value == std::string_view::npos) return false;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> held & 255U));
  }
  return held < 6;
}

tl::unexpected<Error> broken(std::string message) { return tl::unexpected(Error{"", 0, 0, std::move(message), ""}); }

}  // namespace

std::string pack_text(std::string_view text) {
  if (text.empty()) return {};
  z_stream stream{};
  constexpr int most_memory = 9;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, raw_deflate, most_memory, Z_DEFAULT_STRATEGY) != Z_OK)
    return {};
  deflateSetDictionary(&stream, bytes_of(known_words), static_cast<uInt>(known_words.size()));
  std::string packed(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = const_cast<Bytef*>(bytes_of(text));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return base64(packed);
}

Result<std::string> unpack_text(std::string_view letters, std::size_t most) {
  std::string packed;
  if (!from_base64(letters, packed)) return broken("what is packed in it has been changed on its way");
  if (packed.empty()) return std::string();
  z_stream stream{};
  if (inflateInit2(&stream, raw_deflate) != Z_OK) return broken("there is not enough memory to unpack it");
  inflateSetDictionary(&stream, bytes_of(known_words), static_cast<uInt>(known_words.size()));
  stream.next_in = const_cast<Bytef*>(bytes_of(packed));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string text;
  std::array<char, 4096> part{};
  int state = Z_OK;
  while (state == Z_OK && text.size() <= most) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(part.data(), part.size() - stream.avail_out);
  }
  const bool whole = state == Z_STREAM_END && stream.avail_in == 0;
  inflateEnd(&stream);
  if (text.size() > most) return broken(fmt::format("it unpacks to more than the {} bytes that it may", most));
  if (!whole) return broken("what is packed in it has been cut off or changed on its way");
  return text;
}

}  // namespace raywalk
