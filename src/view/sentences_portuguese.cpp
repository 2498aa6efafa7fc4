// The Portuguese names of rays and of how they end, and the sentences of the walk.

#include "view/text.h"

namespace raywalk {

std::string_view portuguese(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "raio primário";
    case RayKind::shadow:
      return "raio de sombra";
    case RayKind::reflect:
      return "raio refletido";
    case RayKind::refract:
      return "raio refratado";
  }
  return {};
}

std::string_view portuguese(Ending ending) {
  switch (ending) {
    case Ending::hit:
      return "encontrou";
    case Ending::missed:
      return "saiu da cena";
    case Ending::blocked:
      return "bloqueado";
    case Ending::reached_light:
      return "chegou à luz";
    case Ending::depth:
      return "não formado: limite de profundidade";
    case Ending::threshold:
      return "não formado: parte pequena demais";
    case Ending::total_internal_reflection:
      return "não formado: reflexão interna total";
    case Ending::path_length:
      return "não formado: comprimento do caminho";
    case Ending::facing_away:
      return "não formado: de costas para a luz";
    case Ending::outside_cone:
      return "não formado: fora do cone da luz";
  }
  return {};
}

std::string_view portuguese(MessageId id) {
  switch (id) {
    case MessageId::start:
      return "Nada correu ainda.";
    case MessageId::pixel_begun:
      return "O pixel {0} é o próximo; SCREEN tem os pixels 0 a {1}.";
    case MessageId::sample_begun:
      return "A amostra {0} do mesmo pixel é a próxima: os seus raios são desenhados de novo.";
    case MessageId::primary_formed:
      return "Um raio primário parte de EYE pelo pixel {0} de SCREEN.";
    case MessageId::found_hit:
      return "O {0} encontra {1} à distância {2}.";
    case MessageId::left_through_surface:
      return "Dentro de {1}, o {0} chega de novo à superfície depois de {2}.";
    case MessageId::found_missed:
      return "O {0} não encontra nada: sai da cena.";
    case MessageId::intersected:
      return "Encontrou {0}; é preciso sombrear esse ponto.";
    case MessageId::intersected_nothing:
      return "Não encontrou nada, e não há o que sombrear: o pixel recebe o fundo.";
    case MessageId::shade_called:
      return "SHADE é chamada com DEPTH {0} para o ponto de {1} que o {2} encontrou.";
    case MessageId::shade_called_unlit:
      return "SHADE é chamada com DEPTH {0} para o ponto de {1} que o {2} encontrou; sem luz não há raios de sombra.";
    case MessageId::shade_missed:
      return "O {0} saiu da cena; por isso SHADE devolve o fundo {1}.";
    case MessageId::shadow_formed:
      return "Um raio de sombra parte de {0} em direção a {1}.";
    case MessageId::shadow_facing_away:
      return "Nenhum raio de sombra se forma: aqui {0} está de costas para {1}, que não o pode iluminar.";
    case MessageId::shadow_outside_cone:
      return "Nenhum raio de sombra se forma: {0} está fora do cone que {1} ilumina.";
    case MessageId::light_reached:
      return "O raio de sombra chega a {0}: a sua luz alcança o ponto.";
    case MessageId::light_filtered:
      return "O raio de sombra chega a {0} através de algo transparente: alcançam o ponto {1} da sua luz.";
    case MessageId::light_blocked:
      return "O raio de sombra é bloqueado por {1}: não chega luz de {0}.";
    case MessageId::light_blocked_by_itself:
      return "O raio de sombra é bloqueado pelo próprio objeto {1}: não chega luz de {0}.";
    case MessageId::reflective:
      return "{0} reflete com peso {1}; aqui cabe um raio refletido.";
    case MessageId::reflective_totally:
      return "Reflexão interna total: nenhuma luz sai de {0} aqui, e o raio refletido leva as duas partes, peso {1}.";
    case MessageId::reflective_totally_in:
      return "Reflexão interna total: nenhuma luz entra em {0} aqui, e o raio refletido leva as duas partes, peso {1}.";
    case MessageId::not_reflective:
      return "{0} não reflete aqui: estas linhas são puladas.";
    case MessageId::reflect_formed:
      return "Um raio refletido parte de {0}; pode trazer no máximo {1} do pixel.";
    case MessageId::reflect_depth:
      return "Nenhum raio refletido se forma: SHADE não pode ir além de DEPTH {0}.";
    case MessageId::reflect_threshold:
      return "Nenhum raio refletido se forma: traria só {0} do pixel, menos que o limiar de {1}.";
    case MessageId::transparent:
      return "{0} deixa passar luz com peso {1}; aqui cabe um raio refratado.";
    case MessageId::not_transparent:
      return "{0} não deixa passar luz: estas linhas são puladas.";
    case MessageId::totally_reflected:
      return "Nenhum raio refratado se forma: a reflexão interna total não deixa nada sair de {0} aqui.";
    case MessageId::totally_reflected_in:
      return "Nenhum raio refratado se forma: a reflexão interna total não deixa nada entrar em {0} aqui.";
    case MessageId::refract_formed_in:
      return "Um raio refratado entra em {0}: {1} graus com a normal viram {2}.";
    case MessageId::refract_formed_out:
      return "Um raio refratado sai de {0}: {1} graus com a normal viram {2}.";
    case MessageId::refract_formed_within:
      return "Em {0} um raio refratado passa do índice {3} ao índice {4}: {1} graus com a normal viram {2}.";
    case MessageId::refract_depth:
      return "Nenhum raio refratado se forma: SHADE não pode ir além de DEPTH {0}.";
    case MessageId::refract_threshold:
      return "Nenhum raio refratado se forma: traria só {0} do pixel, menos que o limiar de {1}.";
    case MessageId::path_length:
      return "Nenhum {0} se forma: o caminho já tem o comprimento máximo.";
    case MessageId::rtnshade_to_main:
      return "As partes são somadas: SHADE devolve {1}, por {0}, a MAIN ALGORITHM.";
    case MessageId::rtnshade_to_caller:
      return "As partes são somadas: SHADE devolve {1}, por {0}, à SHADE de DEPTH {3}, que esperava pelo seu {2}.";
    case MessageId::pixel_put:
      return "O pixel {0} de SCREEN recebe a sua cor final {1}.";
    case MessageId::sample_put:
      return "A amostra {0} traz {1}; a média de todas até aqui, {2}, fica no pixel.";
    case MessageId::image_pixel_begun:
      return "O pixel da imagem na coluna {0}, linha {1}, é o próximo.";
    case MessageId::image_primary_formed:
      return "Um raio primário parte de EYE pelo pixel da imagem na coluna {0}, linha {1}.";
    case MessageId::image_pixel_put:
      return "O pixel da imagem na coluna {0}, linha {1}, recebe a sua cor final {2}.";
    case MessageId::path_called:
      return "FOLLOW PATH é chamada: segue um caminho da luz ao contrário, de EYE até onde o acaso levar.";
    case MessageId::path_goes_on:
      return "Há um raio, um {0}: o caminho continua com ele.";
    case MessageId::path_over:
      return "Não resta raio: o caminho acabou, e FOLLOW PATH devolve {0}.";
    case MessageId::path_met:
      return "Encontrou {0}: conta a luz que parte de lá para cá.";
    case MessageId::path_met_nothing:
      return "Não encontrou nada; o caminho acaba aqui.";
    case MessageId::background_added:
      return "O fundo acrescenta {0} ao pixel; o caminho saiu da cena e acaba.";
    case MessageId::emits_nothing:
      return "{0} não emite luz: nada se acrescenta.";
    case MessageId::emission_added:
      return "{0} emite luz, o que acrescenta {1} ao pixel.";
    case MessageId::emission_weighted:
      return "{0} emite luz; um raio de sombra também podia achá-la, por isso conta {1} e acrescenta {2}.";
    case MessageId::object_aimed_at:
      return "Um raio de sombra parte de {0} em direção a um ponto, sorteado, de um objeto que emite luz.";
    case MessageId::object_not_aimed_at:
      return "Nenhum raio de sombra se forma: aqui {0} está de costas para o ponto sorteado num objeto que emite luz.";
    case MessageId::object_seen:
      return "O raio de sombra chega a {0}: a sua luz alcança o ponto.";
    case MessageId::object_hidden:
      return "O raio de sombra é bloqueado por {0}: não chega luz.";
    case MessageId::light_adds_nothing:
      return "Não chega nada, e nada se acrescenta.";
    case MessageId::light_added:
      return "{0} acrescenta {1} ao pixel.";
    case MessageId::light_added_weighted:
      return "O caminho também podia levar a {0}, por isso conta {1}: acrescenta {2} ao pixel.";
    case MessageId::direction_none:
      return "Nenhuma direção é escolhida: o caminho não continua a partir de {0}.";
    case MessageId::direction_diffuse:
      return "Por acaso {0} o espalha como superfície fosca; na nova direção pode trazer {1} do pixel.";
    case MessageId::direction_highlight:
      return "Por acaso {0} o espalha perto do seu brilho; na nova direção pode trazer {1} do pixel.";
    case MessageId::direction_mirror:
      return "Por acaso {0} o reflete como espelho; na nova direção pode trazer {1} do pixel.";
    case MessageId::direction_transparent:
      return "Por acaso {0} o deixa passar; na nova direção pode trazer {1} do pixel.";
    case MessageId::path_survives:
      return "O caminho sobrevive: por enquanto não corre risco.";
    case MessageId::path_survives_roulette:
      return "Roleta russa: o caminho sobrevive, como {0} deles, e conta tanto mais.";
    case MessageId::path_lost_roulette:
      return "A roleta russa encerra o caminho, que só podia trazer {0} do pixel.";
    case MessageId::path_too_long:
      return "O caminho acaba: pode ter no máximo {0} raios.";
    case MessageId::path_absorbed:
      return "O caminho acaba: {0} absorve o que chega.";
    case MessageId::next_formed:
      return "O caminho parte de {0} por um {1}, que pode trazer {2} do pixel.";
  }
  return {};
}

}  // namespace raywalk
