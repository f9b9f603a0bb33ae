/* host-tools/svg/svg_file.c -- reads the XML of an SVG file safely: ids, style sheets, lines for
 * messages
 * SPDX-License-Identifier: MIT
 *
 * libxml2 reads it, without network and external entities. Its own limits are switched off, since
 * they refuse good drawings. This file has other limits: for elements, for their depth, and for the
 * expansion of entities.
 */
#include <libxml/parser.h>
#include <libxml/SAX2.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "svg/svg.h"
#include "svg/svg_file.h"
#include "base/host.h"
#include "base/memory.h"

/* bytes from entities and defaults, counted for each use */
#define EXPANDED_MAX   ((size_t)16 << 20)
/* bytes that libxml2 copies to append entities to text */
#define COPIED_MAX     ((size_t)4 << 30)
#define ENTITY_DEPTH   8                    /* nested entities */
#define INNER_DEPTH    50                   /* nested elements within one entity */
#define ATTRIBUTES_MAX 1000                 /* per element: libxml2 compares all pairs */


// Messages
// --------

/* Elements of an entity have no line: the line of the element that contains the entity counts. */
unsigned svg_at_line(const svg_reader *r)
{
    const xmlNode *node = r->node;

    while (node->_private == NULL && node->parent != NULL)
        node = node->parent;
    return (unsigned)(size_t)node->_private;
}

/* Behind the last ": " of a text, which ends before it then; NULL: there is none. */
static const char *cut_remedy(char *text)
{
    char *colon = NULL;

    for (char *at = text; (at = strstr(at, ": ")) != NULL; at++)
        colon = at;
    if (colon == NULL)
        return NULL;
    *colon = '\0';
    return colon + 2;
}

bool svg_fail(const svg_reader *r, const char *name, const char *format, ...)
{
    char text[300];
    va_list values;

    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    const char *remedy = cut_remedy(text);
    (void)host_error(r->host, EX_DATAERR, name, (host_place){ r->file, svg_at_line(r) }, remedy,
                     "<%s>: %s", (const char *)r->node->name, text);
    return false;
}

bool svg_goes_on(svg_reader *r, const char *doing)
{
    const host_progress p = { doing, r->visited, r->notes->elements, true };

    r->notes->stopped = !host_goes_on(r->host, &p);
    return !r->notes->stopped;
}

/* The names of warnings. */
static const char *const warning_name[] = {
    [SVG_WARN_SELECTOR] = "svg.selector",
    [SVG_WARN_DATA] = "svg.data",
    [SVG_WARN_TEXT] = "svg.text",
    [SVG_WARN_LETTER] = "svg.letter",
    [SVG_WARN_LAYER] = "svg.layer",
    [SVG_WARN_LAYER_NUMBERS] = "svg.layer-numbers",
    [SVG_WARN_LINE] = "svg.line",
    [SVG_WARN_UPRIGHT] = "svg.upright",
    [SVG_WARN_TEXT_STYLE] = "svg.text-style",
    [SVG_WARN_GEOMETRY] = "svg.geometry",
    [SVG_WARN_MOTION] = "svg.motion",
    [SVG_WARN_PICTURE] = "svg.picture",
    [SVG_WARN_CLIP_PATH] = "svg.clip-path",
    [SVG_WARN_MASK] = "svg.mask",
    [SVG_WARN_PATTERN] = "svg.pattern",
    [SVG_WARN_DASHES] = "svg.dashes",
    [SVG_WARN_BOX] = "svg.box",
    [SVG_WARN_UNSEEN] = "svg.unseen",
    [SVG_WARN_USE_NOTHING] = "svg.use-nothing",
    [SVG_WARN_USE_ELSEWHERE] = "svg.use-elsewhere",
    [SVG_WARN_USE_MISSING] = "svg.use-missing",
    [SVG_WARN_USE_CYCLE] = "svg.use-cycle",
    [SVG_WARN_LENGTH] = "svg.length",
    [SVG_WARN_SIZE] = "svg.size",
    [SVG_WARN_TRANSFORM] = "svg.transform",
    [SVG_WARN_VIEW] = "svg.view",
    [SVG_WARN_FAR] = "svg.far",
    [SVG_WARN_MEDIA] = "svg.media",
    [SVG_WARN_FILTER] = "svg.filter",
    [SVG_WARN_BLEND] = "svg.blend",
    [SVG_WARN_PAGE] = "svg.page",
    [SVG_WARN_BACKGROUND] = "svg.background",
};

static void say_once(const svg_reader *r, enum svg_warning kind, const char *format, va_list values)
{
    char text[300];

    if (r->notes->warned & 1ull << kind)
        return;
    r->notes->warned |= 1ull << kind;
    vsnprintf(text, sizeof text, format, values);
    const char *remedy = cut_remedy(text);
    host_warn(r->host, warning_name[kind], (host_place){ r->file, svg_at_line(r) }, remedy, "%s",
              text);
}

void svg_warn(const svg_reader *r, enum svg_warning kind, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    say_once(r, kind, format, values);
    va_end(values);
}

void svg_lose(const svg_reader *r, enum svg_warning kind, const char *format, ...)
{
    va_list values;

    r->notes->lost = true;
    va_start(values, format);
    say_once(r, kind, format, values);
    va_end(values);
}


// Ids and style sheets
// --------------------

static const xmlChar svg_namespace[]   = "http://www.w3.org/2000/svg";

bool svg_is(const xmlNode *node, const char *name)
{
    return node->type == XML_ELEMENT_NODE &&
           (node->ns == NULL || xmlStrEqual(node->ns->href, svg_namespace)) &&
           (name == NULL || strcmp((const char *)node->name, name) == 0);
}

/* The next element in the file, children first. */
static const xmlNode *following_element(const xmlNode *node)
{
    if (node->children != NULL && node->type == XML_ELEMENT_NODE)
        return node->children;
    while (node != NULL && node->next == NULL)
        node = node->parent;
    return node ? node->next : NULL;
}

typedef struct {
    svg_named named;
    size_t order;
} numbered;

static int compare_ids_and_order(const void *a, const void *b)
{
    const numbered *x = a, *y = b;
    const int order = strcmp(x->named.id, y->named.id);

    return order ? order : (x->order > y->order) - (x->order < y->order);
}

/* Collect ids and style sheets. */
static void collect_ids(svg_reader *r, const xmlNode *root)
{
    numbered *list = NULL;
    size_t count = 0, room = 0;

    for (const xmlNode *node = root; node != NULL; node = following_element(node)) {
        char *id = node->type == XML_ELEMENT_NODE ? svg_attribute(node, "id") : NULL;
        if (id != NULL) {
            if (count == room)
                list = memory_grow(list, (room = room ? 2 * room : 64) * sizeof *list);
            list[count] = (numbered){ { id, node }, count };
            count++;
        }
        r->node = node;
        if (svg_is(node, "style"))
            svg_sheet_read(r, node);
    }
    if (count > 0)
        qsort(list, count, sizeof *list, compare_ids_and_order);
    r->named = memory_grow(NULL, count * sizeof *r->named);
    for (size_t i = 0; i < count; i++)
        if (r->named_count == 0 || strcmp(r->named[r->named_count - 1].id, list[i].named.id) != 0)
            r->named[r->named_count++] = list[i].named;
        else
            xmlFree(list[i].named.id);
    free(list);
}


// XML
// ---

/* What the XML parser reports while it reads. */
typedef struct {
    xmlParserCtxtPtr outer;     /* of the file; libxml2 creates others to read entities */
    char message[200];          /* of the first error; later ones follow from it */
    int line;
    bool stopped;               /* at a limit                                                 */
    unsigned elements;
    size_t expanded, room;      /* bytes from entities and defaults, and their limit */
    size_t copied;
} report;

static void keep_first_error(report *r, xmlErrorPtr error)
{
    if (r->message[0] != '\0' || error->level < XML_ERR_ERROR ||
        error->domain == XML_FROM_NAMESPACE)
        return;
    const char *text = error->message ? error->message : "unknown";

    if (error->code == XML_ERR_INVALID_ENCODING || error->domain == XML_FROM_I18N ||
        strncmp(text, "Input is not proper UTF-8", 25) == 0)
        snprintf(r->message, sizeof r->message,
                 "broken XML: characters that are not UTF-8: save it as UTF-8, or say its encoding "
                 "in its first line");
    else
        snprintf(r->message, sizeof r->message, "broken XML: %.*s: save it again, or mend it there",
                 (int)strcspn(text, "\n"), text);
    r->line = error->line > 0 || r->outer->input == NULL ? error->line : r->outer->input->line;
}

static void keep_error_of_parser(void *context, xmlErrorPtr error)
{
    keep_first_error(((xmlParserCtxtPtr)context)->_private, error);
}

/* What libxml2 finds without a parser, as bytes that are not of the encoding: it prints them, if
 * nobody takes them. */
static void keep_error_of_input(void *context, xmlErrorPtr error)
{
    keep_first_error(context, error);
}

static void stop_at_limit(xmlParserCtxtPtr parser, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static void stop_at_limit(xmlParserCtxtPtr parser, const char *format, ...)
{
    report *r = parser->_private;
    va_list values;

    if (!r->stopped) {
        va_start(values, format);
        vsnprintf(r->message, sizeof r->message, format, values);
        va_end(values);
        r->line = r->outer->input ? r->outer->input->line : 0;
    }
    r->stopped = true;
    xmlStopParser(parser);
}

static void count_expanded(xmlParserCtxtPtr parser, size_t bytes)
{
    report *r = parser->_private;

    r->expanded += bytes;
    if (r->expanded > r->room)
        stop_at_limit(parser,
                      "its entities stand for more than %zu MB: write out what they stand for",
                      EXPANDED_MAX >> 20);
}

/* The length of an entity after the entities in it are expanded, at most EXPANDED_MAX + 1. libxml2
 * copies an entity that it has already read, so the calls of find_entity alone do not count all.
 * _private holds the result, plus one. */
static size_t full_length(xmlParserCtxtPtr parser, xmlEntityPtr entity, int depth)
{
    if (entity == NULL || entity->content == NULL ||
        entity->etype == XML_INTERNAL_PREDEFINED_ENTITY)
        return 0;
    if (entity->_private != NULL)
        return (size_t)entity->_private - 1;
    if (depth > ENTITY_DEPTH)
        return EXPANDED_MAX + 1;

    size_t sum = (size_t)entity->length;
    for (const char *at = (const char *)entity->content; *(at += strcspn(at, "&%")) != '\0';) {
        const char kind = *at++;
        const size_t length = strcspn(at, ";&%");
        if (at[length] == ';' && *at != '#') {
            xmlChar *name = xmlStrndup((const xmlChar *)at, (int)length);
            sum += full_length(parser,
                               kind == '&' ? xmlSAX2GetEntity(parser, name)
                                           : xmlSAX2GetParameterEntity(parser, name),
                               depth + 1);
            sum = sum > EXPANDED_MAX ? EXPANDED_MAX + 1 : sum;
            xmlFree(name);
        }
        at += length;
    }
    entity->_private = (void *)(sum + 1);
    return sum;
}

/* Entities are looked up here each time they are used: a small file cannot expand to gigabytes. The
 * text before an entity is copied when the entity is appended. */
static xmlEntityPtr count_entity(xmlParserCtxtPtr parser, xmlEntityPtr entity)
{
    report *r = parser->_private;
    const xmlNode *before = parser->node ? parser->node->last : NULL;

    if (entity == NULL || entity->etype == XML_INTERNAL_PREDEFINED_ENTITY)
        return entity;
    count_expanded(parser, full_length(parser, entity, 0));
    if (before != NULL && before->type == XML_TEXT_NODE)
        r->copied += strlen((const char *)before->content);
    if (r->copied > COPIED_MAX)
        stop_at_limit(parser, "too many entities in one text: write out what they stand for");
    return r->stopped ? NULL : entity;
}

static xmlEntityPtr find_entity(void *context, const xmlChar *name)
{
    return count_entity(context, xmlSAX2GetEntity(context, name));
}

static xmlEntityPtr find_parameter(void *context, const xmlChar *name)
{
    return count_entity(context, xmlSAX2GetParameterEntity(context, name));
}

/* The line on which the tag starts that the parser has just read; it contains no other `<`. */
static unsigned tag_line(const xmlParserInput *in)
{
    const xmlChar *at = memrchr(in->base, '<', (size_t)(in->cur - in->base));
    unsigned line = (unsigned)in->line;

    for (; at != NULL && (at = memchr(at, '\n', (size_t)(in->cur - at))) != NULL; at++)
        line--;
    return line;
}

/* The length of what an element has besides its own text: default attributes, and namespaces, which
 * may be defaults too. */
static size_t defaults_length(int namespace_count, const xmlChar **namespaces, int count,
                              int defaulted, const xmlChar **attributes)
{
    size_t sum = 0;

    for (int i = 0; i < namespace_count; i++)
        sum += (size_t)xmlStrlen(namespaces[2 * i + 1]);
    for (int i = count - defaulted; i < count; i++)
        sum += (size_t)(attributes[5 * i + 4] - attributes[5 * i + 3]);
    return sum;
}

static void start_element(void *context, const xmlChar *name, const xmlChar *prefix,
                          const xmlChar *uri, int namespace_count, const xmlChar **namespaces,
                          int count, int defaulted, const xmlChar **attributes)
{
    xmlParserCtxtPtr parser = context;
    report *r = parser->_private;
    const bool inner = parser != r->outer || parser->inputNr > 1;

    count_expanded(parser,
                   defaults_length(namespace_count, namespaces, count, defaulted, attributes));
    if (++r->elements > SVG_ELEMENTS_MAX)
        stop_at_limit(parser, "more than %u elements: split the drawing", SVG_ELEMENTS_MAX);
    if (count > ATTRIBUTES_MAX)
        stop_at_limit(parser, "<%s> has more than %d attributes: leave some out",
                      (const char *)name, ATTRIBUTES_MAX);
    if (parser->nodeNr >= (inner ? INNER_DEPTH : SVG_DEPTH_MAX))
        stop_at_limit(parser, "more than %d nested elements%s: draw with fewer groups",
                      inner ? INNER_DEPTH : SVG_DEPTH_MAX, inner ? " in an entity" : "");
    if (r->stopped)
        return;
    xmlSAX2StartElementNs(context, name, prefix, uri, namespace_count, namespaces, count, defaulted,
                          attributes);
    if (!inner && parser->node != NULL)
        parser->node->_private = (void *)(size_t)tag_line(parser->input);
}

/* Read nothing but the file itself. */
static xmlParserInputPtr load_nothing(const char *url, const char *id, xmlParserCtxtPtr context)
{
    (void)url, (void)id, (void)context;
    return NULL;
}

static xmlDocPtr parse_document(const char *text, size_t size, report *r)
{
    xmlParserCtxtPtr context = xmlNewParserCtxt();
    if (context == NULL)
        return NULL;

    xmlSetExternalEntityLoader(load_nothing);
    *r = (report){ .outer = context, .room = EXPANDED_MAX + size };
    context->_private = r;
    xmlSetStructuredErrorFunc(r, keep_error_of_input);
    context->sax->serror = keep_error_of_parser;
    context->sax->getEntity = find_entity;
    context->sax->getParameterEntity = find_parameter;
    context->sax->startElementNs = start_element;
    context->sax->comment = NULL;
    context->sax->processingInstruction = NULL;
    xmlDocPtr document = xmlCtxtReadMemory(context, text, (int)size, NULL, NULL,
                                           XML_PARSE_NONET | XML_PARSE_NOENT | XML_PARSE_NOCDATA |
                                               XML_PARSE_BIG_LINES | XML_PARSE_HUGE);
    xmlSetStructuredErrorFunc(NULL, NULL);
    xmlFreeParserCtxt(context);
    if (r->stopped && document != NULL) {
        xmlFreeDoc(document);
        document = NULL;
    }
    return document;
}

int drawing_read_svg(host *h, drawing *d, const char *file, const char *text, size_t size)
{
    svg_notes notes = { .warned = 0 };
    svg_reader r = { .host = h, .d = d, .file = file, .words = xmlDictCreate(), .notes = &notes };
    report problem;
    xmlDocPtr document = parse_document(text, size, &problem);
    const xmlNode *root = document ? xmlDocGetRootElement(document) : NULL;
    int code = 0;

    r.node = root;
    if (root == NULL)
        code = host_error(h, EX_DATAERR, "svg.not-xml",
                          (host_place){ file, (unsigned)problem.line }, NULL, "%s",
                          problem.message);
    else if (!svg_is(root, "svg"))
        code = host_error(h, EX_DATAERR, "svg.not-svg", (host_place){ file, svg_at_line(&r) },
                          "<svg xmlns=\"http://www.w3.org/2000/svg\"> is expected",
                          "<%s> is not an SVG drawing", (const char *)root->name);
    else {
        notes.elements = problem.elements;
        collect_ids(&r, root);
        code = svg_draw(&r, root) ? 0 : notes.stopped ? EX_TEMPFAIL : EX_DATAERR;
        host_has_done(h);
    }

    for (size_t i = 0; i < r.named_count; i++)
        xmlFree(r.named[i].id);
    free(r.named);
    svg_sheet_free(r.sheet);
    svg_glyphs_close(r.fonts);
    svg_lines_close(r.lines);
    xmlDictFree(r.words);
    if (document != NULL)
        xmlFreeDoc(document);
    return code;
}

static int probe_svg(const reader *r, const char *file, const char *text, size_t size)
{
    (void)r, (void)file, (void)size;
    return source_is_xml(text) ? READER_XML : READER_NOT;
}

static int read_whole(host *h, drawing *d, const char *file, source *s)
{
    return drawing_read_svg(h, d, file, s->text, s->size);
}

const reader reader_svg = {
    .name = "SVG", .probe = probe_svg, .read = read_whole, .takes = READER_BYTES | READER_LAYERS
};
