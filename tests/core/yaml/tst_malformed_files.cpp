// SPDX-License-Identifier: GPL-3.0-or-later
// Malformed scenario files: one clear problem at its place, whatever is in the file.
#include <QTest>

#include <QTemporaryDir>
#include <filesystem>

#include "core/yaml/scenario_file.h"
#include "tests/support/scenario_texts.h"

using namespace drillwave;

namespace {

using Kind = ScenarioError::Kind;

const std::string good = test::plainT38;

const std::string groups = "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}\n";

/// The good file with one part exchanged.
std::string with(const std::string& from, const std::string& to) {
    return test::replaced(good, from, to);
}

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
}

/// "a:\n a:\n  a:\n": every level one blank further in.
std::string staircase(int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i) text += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
    return text;
}

/// One row: what the file holds, and what must be said about it, where.
void row(const char* name, const std::string& text, Kind kind, int line, const char* message) {
    QTest::newRow(name) << QByteArray::fromStdString(text) << kind << line << QString(message);
}
void invalid(const char* name, const std::string& text, int line, const char* message) {
    row(name, text, Kind::invalid, line, message);
}
void unreadable(const char* name, const std::string& text, int line, const char* message) {
    row(name, text, Kind::unreadable, line, message);
}

}  // namespace

class TestMalformedFiles : public QObject {
    Q_OBJECT

  private slots:
    void theGoodFileIsGood();
    void malformedFilesAreRefusedWithTheirPlace_data();
    void malformedFilesAreRefusedWithTheirPlace();
    void allProblemsAreReportedAtOnceInTheirOrder();
    void aProblemIsNotReportedTwice_data();
    void aProblemIsNotReportedTwice();
    void endlessProblemsAreCutShort();
    void whatIsNoFileIsRefused();
    void aFileTooLargeIsRefusedUnread();
    void columnsCountCharacters();
};

void TestMalformedFiles::theGoodFileIsGood() {
    QVERIFY(validate(parseScenario(good, "").scenario).empty());
}

void TestMalformedFiles::malformedFilesAreRefusedWithTheirPlace_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("message");

    // No YAML, or no text at all.
    unreadable("empty", "", 1, "the file is empty");
    unreadable("only blanks", "\n\n   \n", 1, "the file is empty");
    unreadable("only a comment", "# nothing here\n", 1, "the file is empty");
    unreadable("only a null", "~\n", 1, "the file is empty");
    unreadable("only a byte order mark", "\xEF\xBB\xBF", 1, "the file is empty");
    unreadable("NUL byte", std::string("drillwave: 1\ntitle: a\0b\n", 24), 2, "a NUL byte");
    unreadable("ELF header",
               std::string("\x7F"
                           "ELF\2\1\1\0\0",
                           9),
               1, "a control character");
    unreadable("PNG header", "\x89PNG\r\n\x1a\n", 1, "not UTF-8");
    unreadable("Latin-1 umlaut", with("T38", "f\xFCr"), 2, "not UTF-8");
    unreadable("UTF-16",
               std::string("\xFF\xFE"
                           "d\0r\0",
                           6),
               1, "not UTF-8");
    unreadable("overlong UTF-8", with("T38", "\xC0\xAF"), 2, "not UTF-8");
    unreadable("surrogate", with("T38", "\xED\xA0\x80"), 2, "not UTF-8");
    unreadable("cut UTF-8", good + "# \xE2\x82", 19, "not UTF-8");
    unreadable("escape sequence", with("T38", "\x1B[31m"), 2, "a control character");
    unreadable("lone carriage returns", "drillwave: 1\rtitle: a\r", 1, "a carriage return");
    unreadable("open quote", with("T38", "\"T38"), 2, "the quote that begins here is not closed");
    unreadable("open single quote", with("8 kN", "'8 kN"), 18, "the quote that begins here is not closed");
    unreadable("open quote before an escape", with("8 kN", "\"8 kN\\\""), 18, "not YAML");
    unreadable("open brace", groups + "pulse: {shape: rectangular\n", 4, "not YAML");
    unreadable("stray bracket", with("38 mm", "] 38 mm"), 5, "not YAML");
    unreadable("tab as indentation", with("  diameter", "\tdiameter"), 5, "not YAML");
    unreadable("two colons", with("length: 3.66 m", "length: 3.66: m"), 4, "not YAML");
    unreadable("wrong escape", with("T38", "\"\\q\""), 2, "not YAML");
    unreadable("half a character in an escape", with("T38", "\"\\\xC3\xBC\""), 2, "not YAML");
    unreadable("undefined alias", with("38 mm", "*d"), 5, "not YAML");
    unreadable("repeated directive", "%YAML 1.2\n%YAML 1.2\n---\n" + good, 2, "not YAML");

    // YAML beyond what a scenario needs.
    invalid("anchor", with("38 mm", "&d 38 mm"), 5, "an anchor (&)");
    invalid("alias", "drillwave: 1\ntitle: &t x\npulse: *t\n", 2, "an anchor (&)");
    invalid(
        "alias bomb",
        "a: &a [x,x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a,*a,*a,*a]\nc: &c [*b,*b,*b,*b,*b,*b,*b,*b,*b]\n",
        1, "an anchor (&)");
    invalid("tag", with("38 mm", "!!str 38 mm"), 5, "a tag (!)");
    invalid("own tag", with("rod:", "rod: !rod"), 3, "a tag (!)");
    invalid("two documents", good + "---\n" + good, 19, "a second document");
    invalid("merge key", "drillwave: 1\n<<: {title: x}\n" + good.substr(13), 2, "<< (is not a known key");
    invalid("list as a key", "drillwave: 1\n? [a, b]\n: c\n", 2, "a key must be a plain name");
    invalid("100 levels of brackets", "drillwave: 1\na: " + repeated("[", 100) + repeated("]", 100), 2,
            "levels of nesting");
    invalid("100 levels of braces", "drillwave: 1\na: " + repeated("{a: ", 100) + repeated("}", 100), 2,
            "levels of nesting");
    invalid("100 levels of indentation", staircase(100), 33, "levels of nesting");
    invalid("100 levels of dashes", repeated("- ", 100), 1, "levels of nesting");
    invalid("100 000 brackets", repeated("[", 100000), 1, "levels of nesting");
    invalid("1 000 000 open braces", repeated("{", 1000000), 1, "levels of nesting");
    invalid("1 000 levels of indentation", staircase(1000), 33, "levels of nesting");
    invalid("500 000 values", "drillwave: 1\na: [" + repeated("1,", 500000) + "1]", 2, "too many values");

    // Not a scenario.
    invalid("a word", "hello\n", 1, "drillwave (the file must be lines");
    invalid("a list", "- drillwave: 1\n", 1, "drillwave (the file must be lines");
    invalid("another program's file", "services: {web: {image: x}}\n", 1, "drillwave (is missing");
    invalid("no format number", good.substr(13), 1, "drillwave (is missing");
    invalid("format number not first", "title: x\ndrillwave: 1\n" + good.substr(24), 2,
            "drillwave (must be the first");
    invalid("newer format", with("drillwave: 1", "drillwave: 3\nnew_section: {a: 1}"), 1,
            "says drillwave: 3; this program reads up to 2");
    invalid("far newer format", with("drillwave: 1", "drillwave: 99999999999999999999"), 1, "reads up to 2");
    invalid("format zero", with("drillwave: 1", "drillwave: 0"), 1,
            "drillwave = 0 (the format number must be 1");
    invalid("format text", with("drillwave: 1", "drillwave: one"), 1, "drillwave = one (");
    invalid("format 1.0", with("drillwave: 1", "drillwave: 1.0"), 1, "drillwave = 1.0 (");
    invalid("format without value", with("drillwave: 1", "drillwave:"), 1, "drillwave");
    invalid("title is a list", with("T38", "[T38]"), 2, "title (must be text");

    // Keys.
    invalid("unknown key", with("gap: 0 mm", "gap: 0 mm\n  hardness: 3"), 17,
            "bit_rock.hardness (is not a known key");
    invalid("mistyped key", with("length:", "lenght:"), 4,
            "rod.lenght (is not a known key, did you mean `length`?");
    invalid("upper-case key", with("gamma:", "Gamma:"), 15, "did you mean `gamma`?");
    invalid("unknown section", good + "rig: {mast: 3 m}\n", 19, "rig (is not a known key");
    invalid("huge key", with("gap", std::string(900, 'g')), 16, "bit_rock.gggg");
    invalid("duplicate key", with("length: 3.66 m", "length: 3.66 m\n  length: 4 m"), 5,
            "rod.length (is given twice");
    invalid("duplicate section", good + "rod: {length: 3 m}\n", 19, "rod (is given twice");
    invalid(
        "duplicate group",
        "drillwave: 1\ndimensionless: {beta: 1, gamma: 1,\n tau: 1, beta: 2}\npulse: {shape: rectangular}\n",
        3, "dimensionless.beta (is given twice");
    invalid("missing section", groups, 1, "pulse (is missing");
    invalid("missing rod",
            "drillwave: 1\npulse: {shape: rectangular, duration: 1 us, impulse: 1 N s}\n"
            "bit_rock: {stiffness: 1 MN/m, gamma: 1}\n",
            1, "rod (is missing");
    invalid("missing value", with("  length: 3.66 m\n", ""), 3,
            "rod.length (is missing: write for example `length: 3.66 m`");
    invalid("missing diameter", with("  diameter: 38 mm\n  bore: 14.5 mm\n", ""), 3,
            "rod.diameter (is missing: give it or rod.area");
    invalid("missing shape", with("  shape: rectangular\n", ""), 9,
            "pulse.shape (is missing, one of rectangular");
    invalid("missing impulse", with("  impulse: 51 N s\n", ""), 9,
            "pulse.impulse (is missing: give it or pulse.force");
    invalid("missing gamma", with("  gamma: 0.1\n", ""), 13, "bit_rock.gamma (is missing");
    invalid("missing group",
            "drillwave: 1\ndimensionless: {beta: 1, gamma: 1}\npulse: {shape: rectangular}\n", 2,
            "dimensionless.tau (is missing");
    invalid("key without value", with("gamma: 0.1", "gamma:"), 15,
            "bit_rock.gamma (has no value: write for example `gamma: 0.1`");
    invalid("section without value", with("  thrust: 8 kN\n", "") + "pulse2:\n", 18, "pulse2");
    invalid("section is text", with("rod:\n  length: 3.66 m\n", "rod: T38\nxod:\n"), 3,
            "rod (must be a section");
    invalid("section is a list", groups + "pulse: [rectangular]\n", 3, "pulse (must be a section");

    // Both ways of saying it.
    invalid("rod and groups", good + "dimensionless: {beta: 1, gamma: 1, tau: 1}\n", 3,
            "rod (cannot be combined with `dimensionless`");
    invalid("drill and groups", groups + "pulse: {shape: rectangular}\ndrill: {thrust: 1 kN}\n", 4,
            "drill (cannot be combined with");
    invalid("diameter and area", with("38 mm", "38 mm\n  area: 1134 mm^2"), 6,
            "rod.area (cannot be combined with rod.diameter");
    invalid("area and bore", with("diameter: 38 mm", "area: 1134 mm^2"), 6, "rod.bore (goes with a diameter");
    invalid("impulse and force", with("51 N s", "51 N s\n  force: 255 kN"), 13,
            "pulse.force (cannot be combined with pulse.impulse");
    invalid("file and points", groups + "pulse: {shape: table, file: a.csv, points: [[0, 1], [1, 1]]}\n", 3,
            "pulse.points (cannot be combined with pulse.file");

    // Values.
    invalid("no unit", with("38 mm", "38"), 5,
            "rod.diameter = 38 (has no unit: write for example `38 mm`; allowed units: m, mm");
    invalid("wrong unit", with("38 mm", "38 kN"), 5, "rod.diameter = 38 kN (unit `kN` is not known here");
    invalid("unit on a ratio", with("gamma: 0.1", "gamma: 0.1 m"), 15,
            "bit_rock.gamma = 0.1 m (must be a plain number");
    invalid("word for a number", with("0.1", "small"), 15, "bit_rock.gamma = small (is not a number)");
    invalid("YAML nan", with("0.1", ".nan"), 15, "bit_rock.gamma = .nan (must be a finite number)");
    invalid("nan with a unit", with("3.66 m", "nan m"), 4, "rod.length = nan m (must be a finite number)");
    invalid("infinity", with("0 mm", ".inf"), 16, "bit_rock.gap = .inf (must be a finite number)");
    invalid("overflow", with("3.66 m", "1e999 m"), 4, "rod.length = 1e999 m (is too large");
    invalid("decimal comma", with("3.66 m", "3,66 m"), 4, "a decimal comma is not read here");
    invalid("hexadecimal", with("0.1", "0x1"), 15, "bit_rock.gamma = 0x1");
    invalid("boolean", with("0.1", "true"), 15, "bit_rock.gamma = true (is not a number)");
    invalid("list for a number", with("0.1", "[0.1]"), 15, "bit_rock.gamma (must be one value");
    invalid("map for a number", with("0.1", "{value: 0.1}"), 15, "bit_rock.gamma (must be one value");
    invalid("huge text for a number", with("0.1", std::string(500000, 'x')), 15, "bit_rock.gamma = xxxx");
    invalid("a million digits", with("0.1", std::string(900000, '9')), 15, "bit_rock.gamma = 9999");
    invalid("gamma above 1", with("0.1", "1.3"), 15, "bit_rock.gamma = 1.3 (must be in (0, 1])");
    invalid("gamma zero", with("0.1", "0"), 15, "bit_rock.gamma = 0 (must be in (0, 1])");
    invalid("negative length", with("3.66 m", "-3.66 m"), 4, "rod.length = -3.66 m (must be greater than 0)");
    invalid("negative gap", with("0 mm", "-1 mm"), 16, "bit_rock.gap = -1 mm (must be at least 0)");
    invalid("bore too large", with("14.5 mm", "38 mm"), 6,
            "rod.bore = 38 mm (must be less than the diameter");
    invalid("overflow of a group", with("51 N s", "1e-307 N s"), 1, "the values are too large or too small");
    invalid("overflow of beta", with("200 us", "1e307 s"), 14, "it follows from the other values");
    invalid("beta zero",
            "drillwave: 1\ndimensionless: {beta: 0, gamma: 1, tau: 1}\npulse: {shape: rectangular}\n", 2,
            "dimensionless.beta = 0 (must be greater than 0)");

    // Shapes.
    invalid("unknown shape", with("rectangular", "square"), 10,
            "pulse.shape = square (must be one of rectangular");
    invalid("shape is a list", with("rectangular", "[rectangular]"), 10, "pulse.shape");
    invalid("rise without trapezoid", with("51 N s", "51 N s\n  rise: 0.1"), 13,
            "pulse.rise (only for a trapezoid");
    invalid("rise and fall too long", groups + "pulse:\n  shape: trapezoid\n  rise: 0.8\n  fall: 0.8\n", 6,
            "pulse.fall = 0.8 (rise and fall together");
    invalid("piston with duration", with("rectangular", "piston"), 11,
            "pulse.duration (follows from the data of the piston");
    invalid("piston too stiff", groups + "pulse: {shape: piston, impedance_ratio: 1e9}\n", 3,
            "use the shape exponential");
    invalid("duration without dimension", groups + "pulse: {shape: rectangular, duration: 1 us}\n", 3,
            "pulse.duration (the scenario is given by");
    invalid("points without table", groups + "pulse: {shape: rectangular, points: [[0, 1], [1, 1]]}\n", 3,
            "pulse.points (only for a table");
    invalid("table without points", groups + "pulse: {shape: table}\n", 3,
            "pulse.file (is missing: give it or pulse.points");
    invalid("points are no list", groups + "pulse: {shape: table, points: 3}\n", 3,
            "pulse.points (must be a list of [time, force]");
    invalid("points are no pairs", groups + "pulse:\n  shape: table\n  points:\n  - [0, 1]\n  - [1]\n", 7,
            "pulse.points (each point must be [time, force]");
    invalid("a point with a unit", groups + "pulse: {shape: table, points: [[0, 1], [1 us, 1]]}\n", 3,
            "pulse.points = 1 us (must be a plain number");
    invalid("points backwards", groups + "pulse: {shape: table, points: [[0, 1], [1, 1], [1, 2]]}\n", 3,
            "pulse.points (point 3 must be later");
    invalid("one point", groups + "pulse: {shape: table, points: [[0, 1]]}\n", 3,
            "pulse.points (needs at least two points");
    invalid("table file without name", groups + "pulse: {shape: table, file: }\n", 3,
            "pulse.file (must be the name of a CSV file");
    unreadable("table file that is not there", groups + "pulse: {shape: table, file: not-there.csv}\n", 3,
               "pulse.file = not-there.csv (the pulse table cannot be opened");
    unreadable("table file is a folder", groups + "pulse: {shape: table, file: .}\n", 3,
               "pulse.file = . (the pulse table is a folder");
}

void TestMalformedFiles::malformedFilesAreRefusedWithTheirPlace() {
    QFETCH(QByteArray, text);
    QFETCH(Kind, kind);
    QFETCH(int, line);
    QFETCH(QString, message);
    QTemporaryDir folder;
    const QString path = folder.filePath("case.yaml");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
    file.close();
    try {
        loadScenario(path.toStdString());
        QFAIL("the file was accepted");
    } catch (const ScenarioError& error) {
        QVERIFY2(error.kind() == kind, error.what());
        const auto isExpected = [&](const InputProblem& problem) {
            return problem.line == line && QString::fromStdString(problem.text.text()).contains(message);
        };
        QVERIFY2(std::ranges::any_of(error.problems(), isExpected), error.what());
        // Each says why in words that other languages have, too.
        for (const InputProblem& problem : error.problems()) {
            const auto nothing = [](const std::string& english) {
                return QString::fromStdString(english)
                    .remove(QRegularExpression(QStringLiteral("\\p{L}")))
                    .toStdString();
            };
            QVERIFY2(problem.text.said(nothing) != problem.text.text(), problem.text.text().c_str());
        }
        // Whatever is in the file, a message is one short line of text.
        for (const std::string& said : error.lines()) {
            QVERIFY(said.starts_with(path.toStdString() + ":"));
            QVERIFY(said.size() < path.toStdString().size() + 400);
            QVERIFY(said.find('\n') == std::string::npos);
            QVERIFY(QString::fromUtf8(said.c_str()).toStdString() == said);
        }
    }
}

void TestMalformedFiles::allProblemsAreReportedAtOnceInTheirOrder() {
    std::string text = with("3.66 m", "3.66");
    text.replace(text.find("bore: 14.5 mm"), 13, "bore: 40 mm");
    text.replace(text.find("gamma: 0.1"), 10, "gamma: 1.3");
    text += "colour: red\n";
    try {
        parseScenario(text, "case.yaml");
        QFAIL("the file was accepted");
    } catch (const ScenarioError& error) {
        QStringList lines;
        for (const std::string& line : error.lines())
            lines << QString::fromStdString(line).section(" (", 0, 0);
        QCOMPARE(lines, QStringList({"case.yaml:4:11: rod.length = 3.66", "case.yaml:6:9: rod.bore = 40 mm",
                                     "case.yaml:15:10: bit_rock.gamma = 1.3", "case.yaml:19:1: colour"}));
    }
}

void TestMalformedFiles::aProblemIsNotReportedTwice_data() {
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, const std::string& text) {
        QTest::newRow(name) << QString::fromStdString(text);
    };
    row("bore beside a wrong diameter", with("38 mm", "38 kN"));
    row("bore beside a missing diameter", with("  diameter: 38 mm\n", ""));
    row("mistyped required key", with("length", "lenght"));
    row("mistyped section", with("bit_rock", "bitrock"));
    row("mistyped shape key", with("shape", "shap"));
    row("mistyped alternative", with("impulse", "impulze"));
    row("wrong shape with keys of its own", with("rectangular", "trapezium\n  rise: 0.1"));
    row("wrong point", groups + "pulse: {shape: table, points: [[0, 1], [x, 1]]}\n");
    row("wrong rise beside a large fall", groups + "pulse: {shape: trapezoid, rise: x, fall: 0.9}\n");
    row("missing pulse", groups);
}

void TestMalformedFiles::aProblemIsNotReportedTwice() {
    QFETCH(QString, text);
    try {
        parseScenario(text.toStdString(), "case.yaml");
        QFAIL("the file was accepted");
    } catch (const ScenarioError& error) {
        QVERIFY2(error.problems().size() == 1, error.what());
    }
}

void TestMalformedFiles::endlessProblemsAreCutShort() {
    std::string text = "drillwave: 1\n";
    for (int i = 0; i < 50000; ++i) text += "key" + std::to_string(i) + ": 1\n";
    try {
        parseScenario(text, "case.yaml");
        QFAIL("the file was accepted");
    } catch (const ScenarioError& error) {
        QVERIFY(error.problems().size() <= 101);
        const std::string last = error.lines().back();
        QVERIFY2(last.find("more problems") != std::string::npos, last.c_str());
    }
}

void TestMalformedFiles::whatIsNoFileIsRefused() {
    QTemporaryDir folder;
    for (const std::string& path : {folder.path().toStdString(), folder.filePath("none.yaml").toStdString(),
                                    std::string("/dev/zero"), std::string()}) {
        try {
            loadScenario(path);
            QFAIL("it was accepted");
        } catch (const ScenarioError& error) {
            QVERIFY(error.kind() == Kind::unreadable);
            QCOMPARE(error.problems().size(), std::size_t{1});
        }
    }
}

void TestMalformedFiles::aFileTooLargeIsRefusedUnread() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("large.yaml").toStdString();
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(good));
    // A sparse file of 8 GiB: reading it whole would be noticed.
    QVERIFY(file.resize(qint64{8} << 30));
    file.close();
    try {
        loadScenario(path);
        QFAIL("it was accepted");
    } catch (const ScenarioError& error) {
        QVERIFY(error.kind() == Kind::unreadable);
        QVERIFY2(std::string(error.what()).find("larger than the limit of 1024 KiB") != std::string::npos,
                 error.what());
    }
    const std::string padded = good + "#" + std::string((std::size_t{1} << 20) - good.size() - 1, ' ');
    QCOMPARE(padded.size(), std::size_t{1} << 20);
    QVERIFY(validate(parseScenario(padded, path).scenario).empty());
    QVERIFY_EXCEPTION_THROWN(parseScenario(padded + " ", path), ScenarioError);
}

void TestMalformedFiles::columnsCountCharacters() {
    const std::string umlauts = "{\"\xC3\xBC\xC3\xBC\": 1, beta: x, gamma: 1, tau: 1}";
    try {
        parseScenario(
            "\xEF\xBB\xBF{drillwave: 1, dimensionless: " + umlauts + ", pulse: {shape: rigid_body}}", "");
        QFAIL("the file was accepted");
    } catch (const ScenarioError& error) {
        QCOMPARE(error.problems().size(), std::size_t{2});
        QCOMPARE(error.problems()[0].column, 32);
        QCOMPARE(error.problems()[1].column, 47);
    }
}

QTEST_APPLESS_MAIN(TestMalformedFiles)
#include "tst_malformed_files.moc"
