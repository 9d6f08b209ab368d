#include "core/io/system/StreamReading.h"

#include "core/io/system/AtomicFile.h"
#include "core/io/system/OpenFile.h"
#include "tests/support/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <thread>

using namespace rubble;
namespace fs = std::filesystem;

namespace {

/// Both ends of a pipe.
struct Pipe {
    Pipe() {
        std::array<int, 2> ends{-1, -1};
        if (::pipe(ends.data()) != 0) qFatal("no pipe");
        read = ends[0];
        write = ends[1];
    }
    ~Pipe() { ::close(read); }
    int read = -1;
    int write = -1;
};

}  // namespace

class StreamReadingTest : public QObject {
    Q_OBJECT
private slots:
    void pipeIsReadToItsEnd() {
        const Pipe pipe;
        const std::string sent(300000, 'x');  // more than a pipe or a buffer holds
        std::jthread writer([&] {
            for (std::size_t at = 0; at < sent.size();) {
                const ssize_t count = ::write(pipe.write, sent.data() + at, sent.size() - at);
                if (count <= 0) break;
                at += static_cast<std::size_t>(count);
            }
            ::close(pipe.write);
        });
        const Result<std::string> bytes = readStream(pipe.read, "pipe", {});
        QVERIFY(bytes && *bytes == sent);
    }
    void cancelledTaskStopsWaiting() {
        const Pipe pipe;
        CancelToken cancel;
        cancel.cancel();
        const Result<std::string> bytes = readStream(pipe.read, "pipe", cancel);
        QVERIFY(!bytes && bytes.error().code == ErrorCode::Cancelled);
        ::close(pipe.write);
    }
    void fileIsReadAndAMissingOneIsNotFound() {
        const QTemporaryDir temporary;
        const fs::path file = fs::path(temporary.path().toStdString()) / "file";
        QVERIFY(readFileOrStream(file, {}).error().code == ErrorCode::NotFound);
        QVERIFY(writeFileAtomically(file, "content"));
        QCOMPARE(*readFileOrStream(file, {}), "content");
    }
    void folderIsAnError() {
        const QTemporaryDir temporary;
        const Result<std::string> bytes = readFileOrStream(temporary.path().toStdString(), {});
        QVERIFY(!bytes && bytes.error().code == ErrorCode::Io);
        QVERIFY2(bytes.error().message.starts_with("Cannot read \""), bytes.error().message.c_str());
    }
};

RUBBLE_TEST(StreamReadingTest)
#include "StreamReadingTest.moc"
