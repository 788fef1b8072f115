// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/open_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

namespace drillwave {

CommandError tooFewFiles(int reason) {
    return {ExitCode::unwritableOutput,
            Message(translatable("nothing can be written: %1; raise the limit of open files (ulimit -n)"),
                    {std::generic_category().message(reason)})};
}

void checkOpenFiles(int count) {
    std::vector<int> opened;
    int reason = 0;
    for (int i = 0; i < count && reason == 0; ++i) {
        const int file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
        if (file >= 0)
            opened.push_back(file);
        else
            reason = errno;
    }
    for (const int file : opened) ::close(file);
    if (reason == EMFILE || reason == ENFILE) throw tooFewFiles(reason);
}

}  // namespace drillwave
