#include <cstdio>

#include "core/model/version.h"

int main() { return std::printf("drillwave %s\n", drillwave::versionText) < 0; }
