#pragma once

#include "tests/support/files/FileBytes.h"

#include <QDir>
#include <QDirIterator>
#include <QMap>
#include <QTest>

namespace rubble {

/// Contents of files by their relative paths.
using FileTree = QMap<QString, QByteArray>;

/// All files below a folder, including hidden ones.
inline FileTree fileTree(const QString& folder) {
    FileTree tree;
    QDirIterator files(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString path = files.next();
        tree[QDir(folder).relativeFilePath(path)] = bytesOfFile(path);
    }
    return tree;
}

/// Writes files below a folder; others that are there stay.
inline void writeFileTree(const QString& folder, const FileTree& tree) {
    for (auto file = tree.begin(); file != tree.end(); ++file) {
        const QString path = folder + '/' + file.key();
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QFile copy(path);
        QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(file.value()) == file.value().size());
    }
}

}  // namespace rubble
