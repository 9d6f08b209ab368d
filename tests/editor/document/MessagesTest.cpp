#include "editor/document/Messages.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>

using namespace rubble;

class MessagesTest : public QObject {
    Q_OBJECT
private slots:
    void messagesOfABakeAreReplaced() {
        Messages messages;
        QSignalSpy spy(&messages, &Messages::changed);
        messages.add({.text = "imported"});
        messages.setOfBake(3, {{.text = "a"}, {.text = "b"}});
        messages.setOfBake(4, {{.text = "other"}});
        messages.setOfBake(3, {{.text = "c"}});
        QStringList texts;
        for (const Message& message : messages.list()) texts.append(message.text);
        QCOMPARE(texts, QStringList({"imported", "other", "c"}));
        QCOMPARE(spy.count(), 4);
        messages.setOfBake(5, {});
        QCOMPARE(spy.count(), 4);
    }
    void messageHasItsSeed() {
        Asset box = boxAsset(1, 2, PlacedSeeds{{{0, {0.2, 0.2}}, {3, {0.7, 0.7}}, {7, {0.2, 0.2}}}});
        box.pattern.layers.push_back({.id = 9, .parameters = UniformScatter{.count = 1}, .overrides = {{.index = 5}}});
        const Result<Bake> baked = bake(box);
        QVERIFY(baked);
        const std::vector<Message> messages = messagesOf(*baked);
        QCOMPARE(messages.size(), std::size_t{2});
        QVERIFY(std::ranges::all_of(messages,
                                    [](const Message& m) { return m.severity == Severity::Warning && m.asset == 1; }));
        QVERIFY((std::ranges::any_of(messages, [](const Message& m) { return m.seed == SeedId{2, 7}; })));
        QVERIFY((std::ranges::any_of(messages, [](const Message& m) { return m.seed == SeedId{9, 5}; })));
    }
};

RUBBLE_TEST_WITH(MessagesTest, QCoreApplication)
#include "MessagesTest.moc"
