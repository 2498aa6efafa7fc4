#include "view/link/qr_code.h"

#include <qrencode.h>

#include <memory>

namespace raywalk {

std::optional<QrCode> qr_code(const std::string& text) {
  if (text.empty() || text.size() > max_qr_letters) return std::nullopt;
  // A seventh of it may be hidden by a reflection on the screen.
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_M),
                                                             &QRcode_free);
  if (made == nullptr) return std::nullopt;
  QrCode code{made->width, {}};
  const std::size_t squares = static_cast<std::size_t>(code.side) * static_cast<std::size_t>(code.side);
  for (std::size_t i = 0; i < squares; ++i) code.dark.push_back((made->data[i] & 1U) != 0);
  return code;
}

}  // namespace raywalk
