#pragma once

#include <string>

namespace rubble {

/// What the kernel supports of a sandbox.
struct Sandbox {
    bool hasSeccomp = false;  // system calls are filtered
    int landlock = 0;         // the version of Landlock that restricts files, TCP and signals; 0 without
    std::string failure;      // why what the kernel supports is not in force; empty if it is
};

/// Confines this process until it ends. It keeps its open descriptors and can compute, allocate, write to its standard
/// streams, open files below `folder` for reading, and exit; every other system call fails. No file is writable, no
/// socket, process or thread can be created, no program executed, no other process traced or signalled, and no memory
/// made executable.
///
/// Where the kernel lacks Landlock, files outside the folder stay readable. The result says what is in force. After a
/// failure no file may be read that is not trusted.
Sandbox enterSandbox(int folder);

/// The sandbox as lines of text: "seccomp: on".
std::string sandboxText(const Sandbox& sandbox);

}  // namespace rubble
