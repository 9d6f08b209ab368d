#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

namespace rubble {

/// The content of a file; empty if it cannot be read.
inline QByteArray bytesOfFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace rubble
