"""Recipe for Conan 2: conan create packaging/conan."""

import os

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy

COMPONENTS = ("core", "motion", "io")


class MusterConan(ConanFile):
    name = "muster"
    version = "0.1.0"
    license = "MIT"
    description = "Interactive formation control of crowds: a deterministic engine with a C++20 and a C99 interface"
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {
        "shared": [True, False],
        "motion": [True, False],
        "io": [True, False],
        "jupedsim": [True, False],
        "host_allocator": [True, False],
    }
    default_options = {
        "shared": True,
        "motion": True,
        "io": True,
        "jupedsim": False,
        "host_allocator": False,
    }

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*", "bindings/c/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        if self.options.io and not self.options.motion:
            raise ConanInvalidConfiguration("option io: found motion switched off, expected it on")
        if self.options.jupedsim and not self.options.io:
            raise ConanInvalidConfiguration("option jupedsim: found io switched off, expected it on")

    def requirements(self):
        self.requires("eigen/3.4.0", visible=False)
        if self.options.motion:
            self.requires("nlohmann_json/3.11.3", visible=False)
        if self.options.jupedsim:
            self.requires("sqlite3/3.45.3")

    def built(self):
        """The components of this build, in order."""
        return [name for name in COMPONENTS if name == "core" or self.options.get_safe(name)]

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["MUSTER_COMPONENTS"] = ";".join(self.built())
        toolchain.cache_variables["MUSTER_BUILD_SHARED"] = bool(self.options.shared)
        toolchain.cache_variables["MUSTER_BUILD_ARCHIVE"] = not self.options.shared
        toolchain.cache_variables["MUSTER_WITH_SQLITE"] = bool(self.options.jupedsim)
        toolchain.cache_variables["MUSTER_HOST_ALLOCATOR"] = bool(self.options.host_allocator)
        for part in ("APPS", "TESTS", "HASHES", "SCALE"):
            toolchain.cache_variables["MUSTER_BUILD_" + part] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        # The package's own files for find_package(muster) and pkg-config hold the targets and their order.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "muster")]
        self.cpp_info.libs = ["muster"]
        if self.options.shared:
            self.cpp_info.defines = ["MUSTER_SHARED=1"]
        elif self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["m", "pthread", "stdc++"]
