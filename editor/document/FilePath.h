#pragma once

#include <QByteArray>
#include <QString>
#include <QVariant>

#include <filesystem>

namespace rubble {

/// Conversions of paths that keep all bytes: one that is not part of UTF-8 becomes an unpaired surrogate, U+DC80 to
/// U+DCFF. Qt's own functions do not find such a file.
/// Source: von Löwis, "Non-decodable Bytes in System Character Interfaces", PEP 383, 2009.
std::filesystem::path toPath(const QString& path);
QString fromPath(const std::filesystem::path& path);

/// The absolute path without "." and "..".
QString absolutePath(const QString& path);

/// What exists at a path; errors count as nothing.
std::filesystem::file_status statusOf(const QString& path);

/// A path as a setting and back; text would lose bytes.
QByteArray settingOf(const QString& path);
QString pathOf(const QVariant& setting);

/// The key under which the settings have what is kept of a project, for its path; empty for one without a file.
QString projectKey(const QString& path);

}  // namespace rubble
