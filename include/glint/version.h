#pragma once
#define GLINT_VERSION "0.1.0"
