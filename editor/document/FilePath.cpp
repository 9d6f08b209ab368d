#include "editor/document/FilePath.h"

#include "core/base/Utf8.h"

#include <QCryptographicHash>

#include <algorithm>
#include <string_view>
#include <system_error>

namespace rubble {

namespace {

constexpr char16_t kFirstByte = 0xDC00;  // stands for the byte 0; those below 0x80 are part of UTF-8

bool isByte(QChar character) {
    return character.unicode() >= kFirstByte + 0x80 && character.unicode() <= kFirstByte + 0xFF;
}

/// The length of the UTF-8 character at the start, or 0.
std::size_t characterLength(std::string_view bytes) {
    for (std::size_t length = 1; length <= 4 && length <= bytes.size(); ++length) {
        if (isUtf8(bytes.substr(0, length))) return length;
    }
    return 0;
}

}  // namespace

std::filesystem::path toPath(const QString& path) {
    QByteArray bytes;
    qsizetype from = 0;
    for (qsizetype k = 0; k < path.size(); ++k) {
        const bool isPaired = k > 0 && path[k - 1].isHighSurrogate();
        if (!isByte(path[k]) || isPaired) continue;
        bytes += path.mid(from, k - from).toUtf8() + static_cast<char>(path[k].unicode() - kFirstByte);
        from = k + 1;
    }
    return (bytes + path.mid(from).toUtf8()).toStdString();
}

QString fromPath(const std::filesystem::path& path) {
    const std::string& native = path.native();
    if (isUtf8(native)) return QString::fromStdString(native);
    QString text;
    for (std::string_view bytes = native; !bytes.empty();) {
        const std::size_t length = characterLength(bytes);
        if (length == 0) {
            text += QChar(kFirstByte + static_cast<unsigned char>(bytes[0]));
        } else {
            text += QString::fromUtf8(bytes.data(), static_cast<qsizetype>(length));
        }
        bytes.remove_prefix(std::max(length, std::size_t{1}));
    }
    return text;
}

QString absolutePath(const QString& path) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(toPath(path), error);
    return error ? path : fromPath(absolute.lexically_normal());
}

std::filesystem::file_status statusOf(const QString& path) {
    std::error_code ignored;
    return std::filesystem::status(toPath(path), ignored);
}

QByteArray settingOf(const QString& path) { return QByteArray::fromStdString(toPath(path).native()); }

QString pathOf(const QVariant& setting) { return fromPath(setting.toByteArray().toStdString()); }

QString projectKey(const QString& path) {
    if (path.isEmpty()) return {};
    return QString::fromLatin1(QCryptographicHash::hash(settingOf(path), QCryptographicHash::Sha1).toHex());
}

}  // namespace rubble
