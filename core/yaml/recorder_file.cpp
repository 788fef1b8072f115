// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/recorder_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/disk/file_bytes.h"
#include "core/disk/whole_file.h"
#include "core/signal/signal_option.h"
#include "core/text/decimal_text.h"
#include "core/text/text_input.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {
namespace {

/// A scalar that YAML reads as the same text, whatever is in it.
std::string quotedSetting(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (c == '\t')
            quoted += "\\t";
        else
            quoted += c;
    }
    return quoted + "\"";
}

class RecorderReader {
  public:
    RecorderReader(std::string_view text, const std::string& source) : m_text(text), m_source(source) {}

    RecorderFile read() {
        if (const TextProblem problem = checkText(m_text); !problem.reason.empty())
            report(problem.offset,
                   {translatable("is not a text file: it holds %1"), {Message::ofTable(problem.reason)}});
        if (!m_file.problems.empty()) return std::move(m_file);
        const YamlTree tree = parseYaml(m_text);
        if (!tree.problem.text.isEmpty()) {
            report(tree.problem.offset, tree.problem.text);
            return std::move(m_file);
        }
        readRoot(tree.root);
        return std::move(m_file);
    }

  private:
    void report(std::size_t offset, const Message& reason) {
        const TextPosition at = positionOf(m_text, offset);
        m_file.problems.push_back(
            about(m_source + ":" + std::to_string(at.line) + ":" + std::to_string(at.column), reason));
    }

    void readRoot(const YamlNode& root) {
        const std::string* format = root.textOf(recorderKey);
        if (root.kind != YamlKind::map || !format || wholeNumberIn<int>(*format) != recorderFormat)
            return report(
                0, translatable("is not a file of recorders; it must begin with `drillwave_recorders: 1`"));
        for (std::size_t i = 0; i + 1 < root.children.size(); i += 2) {
            const YamlNode& key = root.children[i];
            if (key.text == recorderKey) continue;
            if (key.text != "recorders")
                report(key.offset,
                       {translatable("`%1` is not a known key; only `recorders` is"), {shortened(key.text)}});
            else
                readRecorders(root.children[i + 1]);
        }
    }

    void readRecorders(const YamlNode& map) {
        if (map.kind == YamlKind::null) return;
        if (map.kind != YamlKind::map)
            return report(map.offset, translatable("must be a list of recorders with settings"));
        for (std::size_t i = 0; i + 1 < map.children.size(); i += 2)
            readRecorder(map.children[i], map.children[i + 1]);
    }

    void readRecorder(const YamlNode& key, const YamlNode& map) {
        Recorder recorder{key.text, {}};
        if (map.kind != YamlKind::map && map.kind != YamlKind::null)
            return report(map.offset, translatable("must be settings, each `option: value`"));
        SignalOptions checked;
        for (std::size_t i = 0; i + 1 < map.children.size(); i += 2) {
            const YamlNode& name = map.children[i];
            const YamlNode& value = map.children[i + 1];
            const SignalOption* option = findSignalOption(name.text);
            if (!option) {
                report(name.offset,
                       {translatable("`%1` is not an option of drillwave signal"), {shortened(name.text)}});
                continue;
            }
            // A switch is there or not.
            if (option->value.empty() && value.text == "false") continue;
            if (const Message problem = option->set(checked, value.text); !problem.isEmpty())
                report(value.offset, refusedValue(name.text, value.text, problem));
            else
                recorder.settings.emplace_back(name.text, value.text);
        }
        if (findRecorder(m_file.recorders, recorder.name))
            report(key.offset,
                   {translatable("the recorder `%1` is given twice"), {shortened(recorder.name)}});
        m_file.recorders.push_back(std::move(recorder));
    }

    std::string_view m_text;
    const std::string& m_source;
    RecorderFile m_file;
};

}  // namespace

RecorderFile parseRecorders(std::string_view text, const std::string& source) {
    return RecorderReader(text, source).read();
}

const Recorder* findRecorder(const std::vector<Recorder>& recorders, std::string_view name) {
    const auto found = std::ranges::find(recorders, name, &Recorder::name);
    return found == recorders.end() ? nullptr : &*found;
}

std::vector<Recorder> withRecorder(std::vector<Recorder> recorders, Recorder recorder) {
    const auto found = std::ranges::find(recorders, recorder.name, &Recorder::name);
    if (found == recorders.end())
        recorders.push_back(std::move(recorder));
    else
        *found = std::move(recorder);
    return recorders;
}

std::string recorderText(const std::vector<Recorder>& recorders) {
    std::string text = "# Settings of recorders: options of drillwave signal, written by --save-recorder.\n";
    text += std::string(recorderKey) + ": " + std::to_string(recorderFormat) + "\nrecorders:\n";
    for (const Recorder& recorder : recorders) {
        text += "  " + quotedSetting(recorder.name) + ":" + (recorder.settings.empty() ? " {}" : "") + "\n";
        for (const auto& [name, value] : recorder.settings)
            text += "    " + name + ": " + quotedSetting(value) + "\n";
    }
    return text;
}

std::string recordersPath() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const std::filesystem::path folder = config && *config == '/'
                                             ? std::filesystem::path(config)
                                             : std::filesystem::path(home ? home : "") / ".config";
    return (folder / "drillwave" / "recorders.yaml").string();
}

RecorderFile loadRecorders(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return {};
    const FileBytes file = readFile(path, maximumRecorderBytes);
    if (file.problem.isEmpty()) return parseRecorders(file.bytes, path);
    return {{}, {about(path, {translatable("the file of recorders %1"), {file.problem}})}, true};
}

Message saveRecorders(const std::string& path, const std::vector<Recorder>& recorders) {
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
    WholeFile file(path);
    WriteFailure failure = file.open();
    if (!failure) failure = file.write(recorderText(recorders));
    if (!failure) failure = file.commit();
    if (!failure) return {};
    return {translatable("%1: cannot be written: %2"), {path, failure.reason}};
}

Message applyRecorder(const Recorder& recorder, SignalOptions& options) {
    SignalOptions merged;
    for (const auto& [name, value] : recorder.settings) {
        const SignalOption* option = findSignalOption(name);
        if (!option) continue;
        if (const Message problem = option->set(merged, value); !problem.isEmpty())
            return refusedValue(name, value, problem);
    }
    options = merged;
    return {};
}

}  // namespace drillwave
