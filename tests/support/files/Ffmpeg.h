#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>

namespace rubble::test {

/// The first folder of PATH holds this instead of ffmpeg as long as it lives; with no script, PATH holds no program at
/// all.
class Ffmpeg {
public:
    /// Makes a video that holds its own arguments, a line each, where the pictures are there.
    static constexpr const char* kTellsArguments = R"(#!/bin/sh
for video; do :; done
while [ "$1" != -i ]; do echo "$1"; shift; done > "$video"
first=$(printf "$2" 0)
[ -s "$first" ] || { echo "$first: No such file" >&2; exit 1; }
for word; do echo "$word"; done >> "$video"
)";
    /// Makes a video that is the sound it was given.
    static constexpr const char* kKeepsSound = R"(#!/bin/sh
for video; do :; done
for word; do
  case "$word" in */sound.wav) cp "$word" "$video" ;; esac
done
)";
    static constexpr const char* kFails = R"(#!/bin/sh
for video; do :; done
echo half > "$video"
echo "[out] warning" >&2
echo "Error writing trailer: No space left on device" >&2
exit 1
)";

    explicit Ffmpeg(const char* script = nullptr) : m_path(qgetenv("PATH")) {
        QByteArray path = m_folder.path().toUtf8();
        if (script != nullptr) {
            QFile file(m_folder.filePath("ffmpeg"));
            if (!file.open(QIODevice::WriteOnly)) qFatal("no script");
            file.write(script);
            file.close();
            file.setPermissions(file.permissions() | QFile::ExeOwner | QFile::ExeGroup | QFile::ExeOther);
            path += ':' + m_path;
        }
        qputenv("PATH", path);
    }
    ~Ffmpeg() { qputenv("PATH", m_path); }
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

private:
    QByteArray m_path;
    QTemporaryDir m_folder;
};

}  // namespace rubble::test
