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

/// First key of recorders.yaml. Its value is the number of the format; `recorderFormat` is the newest that
/// this program reads.
inline constexpr std::string_view recorderKey = "drillwave_recorders";
inline constexpr int recorderFormat = 1;

/// Largest size of recorders.yaml in bytes; a larger file is refused.
inline constexpr std::size_t maximumRecorderBytes = std::size_t{1} << 20;

struct Recorder {
    std::string name;
    /// Options for reading the records of this recorder, as pairs of name and value; see signalOptions().
    std::vector<std::pair<std::string, std::string>> settings;
    bool operator==(const Recorder&) const = default;
};

/// Settings of all recorders (devices that record signals) in the order of recorders.yaml, or the errors in
/// that file: "recorders.yaml:4:5: …".
struct RecorderFile {
    std::vector<Recorder> recorders;
    std::vector<Message> problems;
    bool isUnreadable = false;  ///< whether the file could not be read from the disk
};

/// Returns the recorders in a text, or its errors; `source` names the text in messages.
RecorderFile parseRecorders(std::string_view text, const std::string& source);

/// Returns the recorder with this name, or nullptr.
const Recorder* findRecorder(const std::vector<Recorder>& recorders, std::string_view name);

/// Returns the recorders after adding one at the end. A recorder of the same name is replaced instead, at its
/// position.
std::vector<Recorder> withRecorder(std::vector<Recorder> recorders, Recorder recorder);

/// Returns the text of a file recorders.yaml with these recorders, which parseRecorders() reads back.
std::string recorderText(const std::vector<Recorder>& recorders);

/// Returns the path of recorders.yaml, in the folder of the user's presets.yaml.
std::string recordersPath();

/// Returns the recorders whose settings a file contains, or its errors. Returns neither recorders nor errors
/// if the file does not exist.
RecorderFile loadRecorders(const std::string& path);

/// Writes recorders.yaml, and makes its folder. Returns an empty message when done, else why it failed.
Message saveRecorders(const std::string& path, const std::vector<Recorder>& recorders);

/// Sets `options` to the settings of the recorder, and all other members of `options` to their defaults.
/// Returns an empty message when done. If a setting has an error, returns this error and changes nothing.
Message applyRecorder(const Recorder& recorder, SignalOptions& options);

}  // namespace drillwave
