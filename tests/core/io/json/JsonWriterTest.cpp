#include "core/io/json/JsonWriter.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>

using namespace rubble;

namespace {

std::string document(JsonLayout layout) {
    JsonWriter json(layout);
    json.openObject();
    json.text("name", "wall");
    json.numbers("sizes", {1.0, 0.5});
    json.points("points", std::vector<Vec2>{{0.0, 1.0}, {2.0, 3.0}});
    json.list("none", std::vector<int>(), [](JsonWriter&, int) {});
    json.boolean("fixed", false);
    json.wholeNumber("parent", std::optional<std::uint32_t>());
    json.close();
    return std::move(json).finished();
}

std::string numbers(JsonLayout layout) {
    JsonWriter json(layout);
    json.numbers({}, {-0.0, 0.0, 1e-7});
    return std::move(json).contents();
}

}  // namespace

class JsonWriterTest : public QObject {
    Q_OBJECT
private slots:
    void numbersThatAreNotFiniteAreNeverWritten() {
        for (const double wrong : {std::nan(""), static_cast<double>(INFINITY)}) {
            // With assertions the child ends; without them it has written null.
            const pid_t child = fork();
            if (child == 0) {
                std::freopen("/dev/null", "w", stderr);
                signal(SIGABRT, SIG_DFL);
                JsonWriter json(JsonLayout::Compact);
                json.numbers({}, {1.0, wrong});
                _exit(std::move(json).contents() == "[1,null]" ? 0 : 1);
            }
            int status = 0;
            QCOMPARE(waitpid(child, &status, 0), child);
            const bool isAsserted = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
            QVERIFY(isAsserted || (WIFEXITED(status) && WEXITSTATUS(status) == 0));
        }
    }
    void layoutsDifferInWhiteSpaceOnly() {
        QCOMPARE(document(JsonLayout::Indented), std::string("{\n"
                                                             "  \"name\": \"wall\",\n"
                                                             "  \"sizes\": [1, 0.5],\n"
                                                             "  \"points\": [\n"
                                                             "    [0, 1],\n"
                                                             "    [2, 3]\n"
                                                             "  ],\n"
                                                             "  \"none\": [],\n"
                                                             "  \"fixed\": false,\n"
                                                             "  \"parent\": null\n"
                                                             "}\n"));
        QCOMPARE(document(JsonLayout::Inline),
                 std::string("{\"name\": \"wall\", \"sizes\": [1, 0.5], \"points\": [[0, 1], [2, 3]], \"none\": [], "
                             "\"fixed\": false, \"parent\": null}"
                             "\n"));
        QCOMPARE(
            document(JsonLayout::Compact),
            std::string("{\"name\":\"wall\",\"sizes\":[1,0.5],\"points\":[[0,1],[2,3]],\"none\":[],\"fixed\":false,"
                        "\"parent\":null}"
                        "\n"));
        QCOMPARE(document(JsonLayout::CompactLines), std::string("{\"name\":\"wall\",\n"
                                                                 "\"sizes\":[1,0.5],\n"
                                                                 "\"points\":[[0,1],[2,3]],\n"
                                                                 "\"none\":[],\n"
                                                                 "\"fixed\":false,\n"
                                                                 "\"parent\":null}\n"));
    }

    void elementsInCompactLinesAreOnLinesOfTheirOwn() {
        JsonWriter chunk(JsonLayout::CompactLines);
        chunk.openArray();
        for (const std::uint64_t id : {1u, 2u}) {
            chunk.openObject();
            chunk.wholeNumber("id", id);
            chunk.close();
        }
        chunk.close();
        const std::string text = std::move(chunk).contents();
        JsonWriter json(JsonLayout::CompactLines);
        json.openArray();
        json.elements(text);
        json.elements("[]");
        json.elements(text);
        json.close();
        QCOMPARE(std::move(json).contents(), std::string("[\n{\"id\":1},\n{\"id\":2},\n{\"id\":1},\n{\"id\":2}]"));
    }

    void signOfZeroIsKeptUnlessCompact() {
        QCOMPARE(numbers(JsonLayout::Indented), std::string("[-0.0, 0, 1e-07]"));
        QCOMPARE(numbers(JsonLayout::Compact), std::string("[0,0,1e-07]"));
    }

    void integersOfEverySizeAreWritten() {
        JsonWriter json(JsonLayout::Compact);
        json.openArray();
        json.wholeNumber({}, ~std::uint64_t{0});
        json.wholeNumbers({}, std::vector<std::uint32_t>{0, 9, 10, 99, 100, 4294967295u});
        json.rows({}, std::array{1, 2}, [](std::int64_t value) { return std::array{value, -value, 100 * value}; });
        json.close();
        QCOMPARE(std::move(json).contents(),
                 std::string("[18446744073709551615,[0,9,10,99,100,4294967295],[[1,-1,100],[2,-2,200]]]"));
    }

    void textIsEscaped() {
        JsonWriter json(JsonLayout::Compact);
        json.openObject();
        json.text("a", "plain");
        json.text("b", "a \"quote\"\n");
        json.close();
        QCOMPARE(std::move(json).contents(), std::string("{\"a\":\"plain\",\"b\":\"a \\\"quote\\\"\\n\"}"));
    }

    void longArraysAndTextsAreWhole() {
        const std::vector<std::uint32_t> indices(10000, 12345);
        const std::string name(20000, 'x');
        JsonWriter json;
        json.openObject();
        json.wholeNumbers("indices", indices);
        json.text("name", name);
        json.close();
        const std::string text = std::move(json).contents();
        QCOMPARE(text.size(), std::string("{\n  \"indices\": [").size() + 7 * indices.size() - 2 +
                                  std::string("],\n  \"name\": \"").size() + name.size() + 3);
        QVERIFY(text.ends_with(name + "\"\n}"));
    }
};

RUBBLE_TEST(JsonWriterTest)
#include "JsonWriterTest.moc"
