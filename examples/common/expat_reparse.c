/* SPDX-License-Identifier: BSD-3-Clause
 * Preloaded, lets ParaView 5.11 read .vtp files where libexpat has its security update of 2024.
 *
 * libexpat now puts off parsing a piece of text that ended within a token. VTK leaves the text at
 * the binary data in a file and relies on everything before that having been parsed: it stops with
 * "junk after document element". This switches the putting off for every parser that is made.
 *
 *   cc -shared -fPIC -o expat_reparse.so expat_reparse.c -ldl
 *   LD_PRELOAD=./expat_reparse.so paraview
 */
#define _GNU_SOURCE
#include <dlfcn.h>

typedef void *Parser;

/* libexpat's own function, also where only a library that was loaded later brings it along. */
static void *own(const char *name)
{
  void *function = dlsym(RTLD_NEXT, name);
  void *expat = function ? 0 : dlopen("libexpat.so.1", RTLD_LAZY);
  return expat ? dlsym(expat, name) : function;
}

static Parser prompt(Parser parser)
{
  unsigned char (*set)(Parser, unsigned char) = own("XML_SetReparseDeferralEnabled");
  if (parser && set)
  {
    set(parser, 0);
  }
  return parser;
}

Parser XML_ParserCreate(const char *encoding)
{
  Parser (*create)(const char *) = own("XML_ParserCreate");
  return create ? prompt(create(encoding)) : 0;
}

Parser XML_ParserCreate_MM(const char *encoding, const void *memory, const char *separator)
{
  Parser (*create)(const char *, const void *, const char *) = own("XML_ParserCreate_MM");
  return create ? prompt(create(encoding, memory, separator)) : 0;
}
