#include "editor/background/BakeQueue.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <array>
#include <memory>
#include <vector>

using namespace rubble;

namespace {

Project twoBoxes() {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, UniformScatter{8}), boxAsset(4, 5, UniformScatter{8})};
    project.assets[1].name = "pillar";
    return project;
}

}  // namespace

class BakeQueueTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_document = std::make_unique<Document>(twoBoxes());
        m_selection = std::make_unique<Selection>();
        m_delivered.clear();
        m_queue = std::make_unique<BakeQueue>(
            *m_document, *m_selection, BakeQueue::Start::Immediately, [this](std::shared_ptr<const Asset> asset) {
                return [this, id = asset->id](const TaskContext&) -> BakeQueue::Delivery {
                    m_gate.acquire();
                    return [this, id] { m_delivered.push_back(id); };
                };
            });
    }
    void cleanup() {
        m_gate.release(10);
        m_queue.reset();
        m_gate.tryAcquire(m_gate.available());
    }
    void activeAssetComesFirst() {
        m_selection->setAsset(4);
        m_gate.release(2);
        m_queue->add({2, 4});
        QTRY_COMPARE(m_delivered, (std::vector<Id>{4, 2}));
        QVERIFY(!m_queue->isBusy());
    }
    void changedAssetIsWorkedOnAgain() {
        m_queue->add({2});
        m_queue->add({2});  // while it is being worked on
        m_gate.release(2);
        QTRY_COMPARE(m_delivered, (std::vector<Id>{2, 2}));
    }
    void resultOfDeletedAssetIsDropped() {
        m_queue->add({2});
        m_document->push(removeAssets(m_document->project(), std::array{Id{2}}));
        m_gate.release(1);
        QTRY_VERIFY(!m_queue->isBusy());
        QVERIFY(m_delivered.empty());
    }
    void cancelClearsTheQueue() {
        QSignalSpy progress(m_queue.get(), &BakeQueue::progressed);
        m_queue->add({2, 4});
        m_queue->cancel();
        QVERIFY(!m_queue->isBusy());
        QCOMPARE(progress.last()[0].value<Id>(), Id{0});
        m_gate.release(2);
        m_queue->add({4});  // on the same thread, after the cancelled one
        QTRY_VERIFY(!m_queue->isBusy());
        QCOMPARE(m_delivered, (std::vector<Id>{4}));
    }

private:
    QSemaphore m_gate;
    std::vector<Id> m_delivered;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Selection> m_selection;
    std::unique_ptr<BakeQueue> m_queue;
};

RUBBLE_TEST_WITH(BakeQueueTest, QCoreApplication)
#include "BakeQueueTest.moc"
