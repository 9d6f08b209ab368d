// Tests app/allocator/OperatorNew.cpp, which the programs and most tests use, and core/base/limits/MemoryReserve.cpp.
#include "core/base/limits/MemoryReserve.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cstdint>
#include <new>

using namespace rubble;

namespace {

volatile std::size_t s_tooMuch = std::size_t{1} << 60;  // bytes; not known to the compiler, which would warn
struct alignas(64) Line {
    char bytes[64];
};
int s_handlerCalls = 0;
void* volatile s_kept = nullptr;  // the compiler leaves out allocations that nobody uses

}  // namespace

class AllocatorTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("Sanitizers have an allocator of their own, which ends the program.");
#endif
    }
    void tooMuchIsAnException() {
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, s_kept = ::operator new(s_tooMuch));
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, s_kept = ::operator new[](s_tooMuch));
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, s_kept = ::operator new(s_tooMuch, std::align_val_t(alignof(Line))));
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, s_kept = new Line[s_tooMuch / sizeof(Line)]);
    }
    void tooMuchIsNullWhereNothingIsThrown() {
        QVERIFY(::operator new(s_tooMuch, std::nothrow) == nullptr);
        QVERIFY(::operator new[](s_tooMuch, std::nothrow) == nullptr);
        QVERIFY(::operator new(s_tooMuch, std::align_val_t(64), std::nothrow) == nullptr);
        QVERIFY(::operator new[](s_tooMuch, std::align_val_t(64), std::nothrow) == nullptr);
    }
    void alignmentIsKept() {
        for (int count : {1, 3, 100}) {
            const std::unique_ptr<Line[]> lines(new Line[static_cast<std::size_t>(count)]);
            QCOMPARE(reinterpret_cast<std::uintptr_t>(lines.get()) % 64, std::uintptr_t{0});
        }
    }
    void theHandlerIsAskedFirst() {
        const std::new_handler before = std::set_new_handler([] {
            if (++s_handlerCalls == 3) std::set_new_handler(nullptr);
        });
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, s_kept = ::operator new(s_tooMuch));
        std::set_new_handler(before);
        QCOMPARE(s_handlerCalls, 3);
    }
    void theReserveIsReleased() {
        holdMemoryReserve();
        QVERIFY(isMemoryReserveHeld());
        QVERIFY(::operator new(s_tooMuch, std::nothrow) == nullptr);
        QVERIFY(!isMemoryReserveHeld());
        holdMemoryReserve();
        holdMemoryReserve();
        QVERIFY(isMemoryReserveHeld());
        releaseMemoryReserve();
        QVERIFY(!isMemoryReserveHeld());
    }
};

RUBBLE_TEST(AllocatorTest)
#include "AllocatorTest.moc"
