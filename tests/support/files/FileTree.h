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

/// Files with zeros in place of the identities of projects, which are random.
inline FileTree withoutIdentities(FileTree files) {
    const QByteArray key = "\"identity\": \"";
    constexpr qsizetype kDigits = 32;
    for (QByteArray& bytes : files) {
        for (qsizetype at = bytes.indexOf(key); at >= 0; at = bytes.indexOf(key, at + 1))
            bytes.replace(at + key.size(), kDigits, QByteArray(kDigits, '0'));
    }
    return files;
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
