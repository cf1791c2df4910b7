#include "report/validation_page.h"
