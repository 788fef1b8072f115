// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of recorders in recorders.yaml: a name, and the options for reading records of this recorder.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/signal/signal_reading.h"
#include "core/text/message.h"

namespace drillwave {

/// First key of recorders.yaml, and the newest format number that this program reads.
inline constexpr std::string_view recorderKey = "drillwave_recorders";
inline constexpr int recorderFormat = 1;

/// Largest size of recorders.yaml in bytes; a larger file is refused.
inline constexpr std::size_t maximumRecorderBytes = std::size_t{1} << 20;

struct Recorder {
    std::string name;
    /// Names and values of options for reading records, see signalOptions().
    std::vector<std::pair<std::string, std::string>> settings;
    bool operator==(const Recorder&) const = default;
};

/// Recorders in the order of their file, or its errors: "recorders.yaml:4:5: …".
struct RecorderFile {
    std::vector<Recorder> recorders;
    std::vector<Message> problems;
    bool isUnreadable = false;  ///< whether the file could not be read from the disk
};

/// Returns the recorders in a text, or its errors; `source` names the text in messages.
RecorderFile parseRecorders(std::string_view text, const std::string& source);

/// Returns the recorder with this name, or nullptr.
const Recorder* findRecorder(const std::vector<Recorder>& recorders, std::string_view name);

/// Returns the recorders with one more, or with the one of the same name replaced; the order does not change.
std::vector<Recorder> withRecorder(std::vector<Recorder> recorders, Recorder recorder);

/// Returns the text of recorders.yaml for these recorders, which parseRecorders() reads back.
std::string recorderText(const std::vector<Recorder>& recorders);

/// Returns the path of recorders.yaml, in the folder of the user's presets.yaml.
std::string recordersPath();

/// Returns the recorders in a file, or its errors; no recorders and no error if the file does not exist.
RecorderFile loadRecorders(const std::string& path);

/// Writes recorders.yaml, and makes its folder. Returns an empty message when done, else why it failed.
Message saveRecorders(const std::string& path, const std::vector<Recorder>& recorders);

/// Sets those members of `options` for which the recorder has settings; other members do not change. Returns
/// an empty message when done, else the error in a setting.
Message applyRecorder(const Recorder& recorder, SignalOptions& options);

}  // namespace drillwave
