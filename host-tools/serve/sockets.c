/* host-tools/serve/sockets.c
 * SPDX-License-Identifier: MIT
 *
 * libwebsockets has one thread. In each turn of its loop the machine is stepped, so the loop waits
 * for its bytes, too. Protocol 0 is that for which libwebsockets has lws_callback_http_dummy: with
 * another one the second request of a connection is damaged.
 */
#include <libwebsockets.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/tool.h"          /* tool_clock */
#include "serve/door.h"
#include "serve/serve.h"
#include "serve/site.h"

#define CONNECTIONS 64          /* at most, of all kinds */
#define CHUNK 16384             /* bytes that are written at once */
#define LONGEST 0.1             /* s of a turn: a signal that comes just before is seen then */
#define SLOW 10                 /* s for a header, and for the next bytes of an upload */

typedef struct {
    serve *s;
    const serve_place *at;
    struct lws_context *context;
    struct lws_vhost *vhost;
    struct lws *machine;        /* watches its bytes */
    int watched;                /* the descriptor that is the machine's; -1: none */
    struct lws *page[SERVE_CLIENTS];
    lws_sorted_usec_list_t timer;
} server;

/* Of one connection. */
typedef struct {
    int client;                 /* of a WebSocket, or -1 */
    bool closes;                /* after the texts that wait */
    char *heard;                /* a text that has not come to its end */
    size_t size;
    const char *says;           /* a text that is sent, */
    size_t left;                /* and what is left of it */
    bool begun;
    /* ---- HTTP */
    site_answer answer;
    size_t sent;
    int upload;                 /* or -1 */
} session;

static server *server_of(struct lws *wsi) { return lws_context_user(lws_get_context(wsi)); }


// Headers
// -------

static const struct lws_protocol_vhost_options header_rows[] = {
    { &header_rows[1], NULL, "content-security-policy:",
      "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
      "img-src 'self' data:; connect-src 'self'; worker-src 'self'; frame-ancestors 'none'; "
      "base-uri 'none'; form-action 'none'" },
    { &header_rows[2], NULL, "x-content-type-options:", "nosniff" },
    { &header_rows[3], NULL, "referrer-policy:", "no-referrer" },
    { &header_rows[4], NULL, "cross-origin-resource-policy:", "same-origin" },
    { &header_rows[5], NULL, "cache-control:", "no-cache" },
    { NULL, NULL, "x-loft:", "serve" },         /* so the page knows that it has a machine */
};

/* "" if there is none. Returns false if it does not fit. */
static bool header(struct lws *wsi, enum lws_token_indexes which, char out[256])
{
    out[0] = '\0';
    return lws_hdr_total_length(wsi, which) == 0 || lws_hdr_copy(wsi, out, 256, which) >= 0;
}

static bool is_host(struct lws *wsi, char asked[256])
{
    return header(wsi, WSI_TOKEN_HOST, asked) && door_host(server_of(wsi)->at->host, asked);
}

static bool is_origin(struct lws *wsi, const char *asked)
{
    char origin[256];

    return header(wsi, WSI_TOKEN_ORIGIN, origin) && door_origin(asked, origin);
}

/* Ends the request; what follows of it is not read. */
static int refuse(struct lws *wsi, unsigned code, const char *what)
{
    (void)lws_return_http_status(wsi, code, what);
    return -1;
}


// Files of the page
// -----------------

static int answer_file(struct lws *wsi, session *c, const char *path)
{
    const server *v = server_of(wsi);
    unsigned char room[LWS_PRE + 2048], *at = room + LWS_PRE, *end = room + sizeof room;
    unsigned char *begin = at;

    c->answer = site_find(v->at->page, path);
    c->sent   = 0;
    if (c->answer.type == NULL && *path == '\0')
        return refuse(wsi, HTTP_STATUS_SERVICE_UNAVAILABLE,
                      "This loft has no page: type `make deps-page page`, then `make tools`, or "
                      "give --page DIR.");
    if (c->answer.type == NULL)
        return refuse(wsi, HTTP_STATUS_NOT_FOUND, "There is no such file.");
    if (lws_add_http_common_headers(wsi, HTTP_STATUS_OK, c->answer.type, c->answer.size, &at, end))
        return -1;
    if (c->answer.own == NULL &&
        lws_add_http_header_by_name(wsi, (const unsigned char *)"content-encoding:",
                                    (const unsigned char *)"gzip", 4, &at, end))
        return -1;
    if (lws_finalize_write_http_header(wsi, begin, &at, end))
        return -1;
    lws_callback_on_writable(wsi);
    return 0;
}

static void forget_answer(session *c)
{
    free(c->answer.own);
    c->answer = (site_answer){ .type = NULL };
}

static int send_file(struct lws *wsi, session *c)
{
    unsigned char room[LWS_PRE + CHUNK];
    const size_t left = c->answer.size - c->sent;
    const size_t size = left < CHUNK ? left : CHUNK;

    if (c->answer.type == NULL)
        return 0;
    memcpy(room + LWS_PRE, c->answer.byte + c->sent, size);
    c->sent += size;
    const bool last = c->sent == c->answer.size;
    if (lws_write(wsi, room + LWS_PRE, size, last ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) < 0)
        return -1;
    if (!last) {
        lws_callback_on_writable(wsi);
        return 0;
    }
    forget_answer(c);
    return lws_http_transaction_completed(wsi) ? -1 : 0;
}


// Uploads
// -------

static int begin_upload(struct lws *wsi, session *c, const char *asked)
{
    static const char header_name[] = "x-loft-token:";
    server *v = server_of(wsi);
    char room[300], token[256] = "", length[256];

    if (!is_origin(wsi, asked))
        return refuse(wsi, HTTP_STATUS_FORBIDDEN,
                      "Another page asks: open the one of this server.");
    if (lws_hdr_custom_length(wsi, header_name, sizeof header_name - 1) > 0)
        (void)lws_hdr_custom_copy(wsi, token, sizeof token, header_name, sizeof header_name - 1);
    if (!serve_knows(v->s, token))
        return refuse(wsi, HTTP_STATUS_UNAUTHORIZED,
                      "Open the address that `loft serve` printed: it has a token behind #.");
    if (!header(wsi, WSI_TOKEN_HTTP_CONTENT_LENGTH, length) || *length == '\0' ||
        strtoull(length, NULL, 10) > SERVE_UPLOAD)
        return refuse(wsi, HTTP_STATUS_REQ_ENTITY_TOO_LARGE, "Give a file of at most 64 MB.");
    const char *name = lws_get_urlarg_by_name(wsi, "name", room, sizeof room);
    c->upload        = serve_upload_begin(v->s, name ? name + (*name == '=') : "");
    return c->upload < 0
               ? refuse(wsi, HTTP_STATUS_SERVICE_UNAVAILABLE, "Other files come in: try again.")
               : 0;
}

static int take_upload(struct lws *wsi, session *c, const void *bytes, size_t size)
{
    if (c->upload >= 0 && !serve_upload_more(server_of(wsi)->s, c->upload, bytes, size))
        return refuse(wsi, HTTP_STATUS_REQ_ENTITY_TOO_LARGE, "Give a file of at most 64 MB.");
    return 0;
}

static int end_upload(struct lws *wsi, session *c)
{
    unsigned char room[LWS_PRE + 2048], *at = room + LWS_PRE, *end = room + sizeof room;
    unsigned char *begin = at;
    char text[64];

    if (c->upload < 0 || !serve_upload_end(server_of(wsi)->s, c->upload, true))
        return refuse(wsi, HTTP_STATUS_INTERNAL_SERVER_ERROR,
                      "The file was not kept: is the disk full?");
    const int size = snprintf(text, sizeof text, "{\"upload\":%d}", c->upload);
    c->upload      = -1;
    if (lws_add_http_common_headers(wsi, HTTP_STATUS_OK, "application/json", (lws_filepos_t)size,
                                    &at, end) ||
        lws_finalize_write_http_header(wsi, begin, &at, end))
        return -1;
    memcpy(room + LWS_PRE, text, (size_t)size);
    if (lws_write(wsi, room + LWS_PRE, (size_t)size, LWS_WRITE_HTTP_FINAL) < 0)
        return -1;
    return lws_http_transaction_completed(wsi) ? -1 : 0;
}

static int begin_request(struct lws *wsi, session *c, const char *path)
{
    char asked[256];

    c->client = c->upload = -1;
    path += *path == '/';
    if (!is_host(wsi, asked))
        return refuse(wsi, 421, "This server has another name: open the address that it printed.");
    if (lws_hdr_total_length(wsi, WSI_TOKEN_POST_URI) > 0)
        return strcmp(path, "upload") == 0
                   ? begin_upload(wsi, c, asked)
                   : refuse(wsi, HTTP_STATUS_NOT_FOUND, "There is no such place.");
    if (lws_hdr_total_length(wsi, WSI_TOKEN_GET_URI) == 0)
        return refuse(wsi, HTTP_STATUS_METHOD_NOT_ALLOWED, "Ask with GET.");
    return answer_file(wsi, c, path);
}


// WebSockets
// ----------

/* Texts of several frames, and frames of several parts. */
static int hear(struct lws *wsi, session *c, const char *bytes, size_t size)
{
    server *v = server_of(wsi);

    if (c->closes)
        return 0;
    if (lws_frame_is_binary(wsi) || size > SERVE_TEXT - c->size)
        return -1;
    c->heard = memory_grow(c->heard, c->size + size + 1);
    if (size > 0)
        memcpy(c->heard + c->size, bytes, size);
    c->size += size;
    if (!lws_is_final_fragment(wsi) || lws_remaining_packet_payload(wsi) > 0)
        return 0;
    c->heard[c->size] = '\0';
    c->closes = !serve_hear(v->s, c->client, c->heard, c->size, tool_clock());
    c->size   = 0;
    lws_callback_on_writable(wsi);
    return 0;
}

static int speak(struct lws *wsi, session *c)
{
    unsigned char room[LWS_PRE + CHUNK];
    server *v = server_of(wsi);

    if (c->says == NULL) {
        c->says  = serve_says(v->s, c->client, tool_clock(), &c->left);
        c->begun = false;
    }
    if (c->says == NULL)
        return c->closes || serve_is_late(v->s, c->client) ? -1 : 0;
    const size_t size = c->left < CHUNK ? c->left : CHUNK;
    memcpy(room + LWS_PRE, c->says, size);
    const bool last = size == c->left;
    const int how   = lws_write_ws_flags(LWS_WRITE_TEXT, !c->begun, last);
    if (lws_write(wsi, room + LWS_PRE, size, (enum lws_write_protocol)how) < 0)
        return -1;
    c->begun = true;
    c->left -= size;
    c->says = last ? NULL : c->says + size;
    lws_callback_on_writable(wsi);
    return 0;
}

static int join(struct lws *wsi, session *c)
{
    server *v = server_of(wsi);

    c->upload = -1;
    c->client = serve_join(v->s);
    if (c->client < 0)
        return -1;
    v->page[c->client] = wsi;
    return 0;
}

static void leave(struct lws *wsi, session *c)
{
    server *v = server_of(wsi);

    free(c->heard);
    c->heard = NULL;
    if (c->client < 0)
        return;
    v->page[c->client] = NULL;
    serve_leave(v->s, c->client);
    c->client = -1;
}

static int answer_socket(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                         size_t size)
{
    session *c = user;
    char asked[256];

    switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return is_host(wsi, asked) && is_origin(wsi, asked) ? 0 : -1;
    case LWS_CALLBACK_ESTABLISHED:       return join(wsi, c);
    case LWS_CALLBACK_RECEIVE:           return hear(wsi, c, in, size);
    case LWS_CALLBACK_SERVER_WRITEABLE:  return speak(wsi, c);
    case LWS_CALLBACK_CLOSED: leave(wsi, c); return 0;
    default: return 0;
    }
}

static int answer_http(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                       size_t size)
{
    session *c = user;

    switch (reason) {
    case LWS_CALLBACK_HTTP:                 return begin_request(wsi, c, in);
    case LWS_CALLBACK_HTTP_BODY:            return take_upload(wsi, c, in, size);
    case LWS_CALLBACK_HTTP_BODY_COMPLETION: return end_upload(wsi, c);
    case LWS_CALLBACK_HTTP_WRITEABLE:       return send_file(wsi, c);
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION: return -1;    /* it names no protocol */
    case LWS_CALLBACK_CLOSED_HTTP:
        if (c == NULL)
            return 0;
        forget_answer(c);
        if (c->upload >= 0)
            (void)serve_upload_end(server_of(wsi)->s, c->upload, false);
        c->upload = -1;
        return 0;
    default: return lws_callback_http_dummy(wsi, reason, user, in, size);
    }
}

static int answer_first(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                        size_t size)
{
    return reason == LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION
               ? -1
               : lws_callback_http_dummy(wsi, reason, user, in, size);
}

/* The bytes of the machine are read by its task. */
static int answer_machine(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in,
                          size_t size)
{
    (void)user;
    (void)in;
    (void)size;
    if (reason == LWS_CALLBACK_RAW_CLOSE_FILE)
        server_of(wsi)->machine = NULL;
    return 0;
}

static const struct lws_protocols protocols[] = {
    { "none", answer_first, 0, 0, 0, NULL, 0 },
    { "http", answer_http, sizeof(session), 0, 0, NULL, 0 },
    { "loft", answer_socket, sizeof(session), 4096, 0, NULL, 0 },
    { "machine", answer_machine, 0, 0, 0, NULL, 0 },
    { NULL, NULL, 0, 0, 0, NULL, 0 }
};


// The loop
// --------

static void watch_machine(server *v, int fd)
{
    if (fd == v->watched && (fd < 0 || v->machine != NULL))
        return;
    if (v->machine != NULL)
        lws_set_timeout(v->machine, PENDING_TIMEOUT_USER_OK, LWS_TO_KILL_SYNC);
    v->machine = NULL;
    v->watched = fd;
    const int copy = fd < 0 ? -1 : dup(fd);
    if (copy < 0)
        return;
    const lws_sock_file_fd_type of = { .filefd = copy };
    v->machine = lws_adopt_descriptor_vhost(v->vhost, LWS_ADOPT_RAW_FILE_DESC, of, "machine", NULL);
    if (v->machine == NULL)
        close(copy);
}

static void wake(lws_sorted_usec_list_t *timer) { (void)timer; }

static void ask_to_write(server *v)
{
    const double now = tool_clock();

    for (int i = 0; i < SERVE_CLIENTS; i++)
        if (v->page[i] != NULL && serve_speaks(v->s, i, now))
            lws_callback_on_writable(v->page[i]);
}

/* In work that takes long. */
static void meanwhile(void *context)
{
    server *v = context;

    ask_to_write(v);
    (void)lws_service(v->context, -1);
}

static int turn(server *v)
{
    task_wants w;
    const double now = tool_clock();

    serve_step(v->s, now, &w);
    watch_machine(v, w.in);
    ask_to_write(v);
    const double left = fmin(w.until - tool_clock(), w.out >= 0 ? 0.002 : LONGEST);
    if (!(left > 0))
        return lws_service(v->context, -1);
    lws_sul_schedule(v->context, 0, &v->timer, wake, (lws_usec_t)(1e6 * left) + 1);
    return lws_service(v->context, 0);
}

static bool listen_there(server *v, host *h)
{
    static const struct lws_http_mount mount = { .mountpoint = "/",
                                                 .origin = "http",
                                                 .protocol = "http",
                                                 .origin_protocol = LWSMPRO_CALLBACK,
                                                 .mountpoint_len = 1 };
    static const lws_retry_bo_t silence = { .secs_since_valid_ping   = 10,
                                            .secs_since_valid_hangup = 20 };
    const bool anywhere = strcmp(v->at->host, "0.0.0.0") == 0;
    struct lws_context_creation_info info;

    memset(&info, 0, sizeof info);
    info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS | LWS_SERVER_OPTION_DISABLE_IPV6;
    info.user    = v;
    info.fd_limit_per_thread = CONNECTIONS;
    lws_set_log_level(0, NULL);
    v->context = lws_create_context(&info);
    info.port      = (int)v->at->port;
    info.iface     = anywhere                                  ? NULL
                 : strcmp(v->at->host, "localhost") == 0 ? "127.0.0.1"
                                                         : v->at->host;
    info.protocols = protocols;
    info.mounts    = &mount;
    info.headers   = header_rows;
    info.timeout_secs             = SLOW;
    info.keepalive_timeout        = 30;
    info.retry_and_idle_policy    = &silence;
    v->vhost = v->context ? lws_create_vhost(v->context, &info) : NULL;
    if (v->vhost != NULL && lws_get_vhost_listen_port(v->vhost) > 0)
        return true;
    (void)host_error(h, EX_UNAVAILABLE, "serve.listen", (host_place){ NULL, 0 },
                     "is another server there? give another address or port", "--listen %s:%u",
                     v->at->host, v->at->port);
    return false;
}

bool serve_is_local(const char *host_name) { return door_is_local(host_name); }

int serve_run(host *h, const serve_options *o, const serve_place *at)
{
    server v          = { .at = at, .watched = -1 };
    serve_options own = *o;
    int code          = 0;

    own.meanwhile = meanwhile;
    own.context   = &v;
    if (!listen_there(&v, h))
        code = EX_UNAVAILABLE;
    if (code == 0) {
        v.s = serve_open(h, &own, tool_clock());
        at->ready(at->host, (unsigned)lws_get_vhost_listen_port(v.vhost), o->token);
        while (!(at->ends() && serve_stop(v.s)) && turn(&v) >= 0)
            ;
    }
    if (v.context != NULL)
        lws_context_destroy(v.context);
    if (v.s != NULL)
        serve_close(v.s);
    return code;
}
