// Tests core/physics/world/World.cpp and core/physics/state/StateSize.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

#include <algorithm>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <new>

#include <malloc.h>

namespace {

std::atomic<long> s_allocations{0};
std::atomic<long> s_bytes{0};  // that are in use

void* allocated(std::size_t size, std::size_t alignment) {
    void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (memory == nullptr) throw std::bad_alloc();
    ++s_allocations;
    s_bytes += static_cast<long>(malloc_usable_size(memory));
    return memory;
}

void freed(void* memory) {
    if (memory == nullptr) return;
    s_bytes -= static_cast<long>(malloc_usable_size(memory));
    std::free(memory);
}

}  // namespace

// All memory of this program is counted.
void* operator new(std::size_t size) { return allocated(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocated(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocated(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void operator delete(void* memory) noexcept { freed(memory); }
void operator delete(void* memory, std::size_t) noexcept { freed(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { freed(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { freed(memory); }

using namespace rubble;

namespace {

long allocationsOf(World& world, int steps) {
    const long before = s_allocations;
    for (int step = 0; step < steps; ++step) world.step(test::kStep);
    return s_allocations - before;
}

/// Bodies that rain into a pen; the oldest is removed when there are too many.
class Rain {
public:
    Rain() : m_random(7), m_scene(test::heapScene(200)), m_moved(test::worldOf(penOf(m_scene))) {
        for (const std::vector<Polytope>& shape : m_scene.shapes) m_shapes.push_back(*makeShape(shape));
    }

    void step() {
        if (++m_steps % 2 == 0) drop();
        if (m_alive.size() > 300) {
            m_moved.world.removeBody(m_alive.front());
            m_alive.pop_front();
        }
        m_moved.world.step(test::kStep);
    }
    /// False if a number is NaN, a body left the pen, or one is faster than it can have fallen.
    bool isSound() const {
        for (const BodyId body : m_alive) {
            const BodyState state = m_moved.world.state(body);
            const Vec3 place = state.pose.position;
            if (!(std::abs(place.x) < 1.5 && std::abs(place.z) < 1.5 && place.y > 0.0 && place.y < 6.0)) return false;
            if (!(glm::length(state.velocity) < 12.0 && glm::length(state.angularVelocity) < 200.0)) return false;
        }
        return true;
    }

private:
    static BodyScene penOf(BodyScene scene) {
        std::erase_if(scene.bodies, [](const SceneBody& body) { return body.kind == BodyKind::Dynamic; });
        return scene;
    }
    void drop() {
        const std::size_t form = 5 + m_random.below(m_shapes.size() - 5);  // the first five are the pen
        const Vec3 place{m_random.between(-1.2, 1.2), m_random.between(4.0, 5.5), m_random.between(-1.2, 1.2)};
        const Result<BodyId> body = m_moved.world.addBody(
            {.shape = m_shapes[form], .pose = {.position = place, .orientation = test::randomRotation(m_random)}});
        m_alive.push_back(*body);
    }

    Random m_random;
    BodyScene m_scene;
    SceneWorld m_moved;
    std::vector<std::shared_ptr<const Shape>> m_shapes;
    std::deque<BodyId> m_alive;
    int m_steps = 0;
};

}  // namespace

/// Memory is allocated when bodies are added, not in steps.
class MemoryTest : public QObject {
    Q_OBJECT
private slots:
    void settledStepAllocatesNothing_data() {
        QTest::addColumn<bool>("sleeping");
        QTest::addColumn<int>("threads");
        QTest::newRow("awake") << false << 1;
        QTest::newRow("awake, two threads") << false << 2;
        QTest::newRow("asleep") << true << 1;
    }
    void settledStepAllocatesNothing() {
        QFETCH(bool, sleeping);
        QFETCH(int, threads);
        SceneWorld moved = test::worldOf(test::heapScene(600), {.sleeping = sleeping, .threads = threads});
        test::simulate(moved.world, 10.0);
        constexpr int kSteps = 320;  // among them some in which the world tries fewer and more threads
        // A worker of the thread library takes memory of its own when it first gets work, which on a busy machine
        // may be late.
        long least = allocationsOf(moved.world, kSteps);
        for (int turn = 1; turn < threads + 2 && least > 0; ++turn) {
            least = std::min(least, allocationsOf(moved.world, kSteps));
        }
        QCOMPARE(least, 0L);
    }
    void memoryStaysConstantInEndlessRain() {
        Rain rain;
        const int seconds = test::isLongRun() ? 600 : 80;  // lists grow for a minute
        long before = 0;
        for (int second = 1; second <= seconds; ++second) {
            for (int step = 0; step < 60; ++step) rain.step();
            QVERIFY2(rain.isSound(), qPrintable(QString("after %1 s").arg(second)));
            if (second == 3 * seconds / 4) before = s_bytes;
        }
        const double growth = static_cast<double>(s_bytes) / static_cast<double>(before) - 1.0;
        qInfo("%ld bytes, %+.2f %% in the last quarter", s_bytes.load(), 100.0 * growth);
        QVERIFY(growth < 0.05);
    }
};

RUBBLE_TEST(MemoryTest)
#include "MemoryTest.moc"
