// The Portuguese texts about bugs.

#include "view/bug_text.h"

namespace raywalk {

std::string_view portuguese(BugText id) {
  switch (id) {
    case BugText::title:
      return "Ache o defeito";
    case BugText::intro:
      return "Cada um destes traçadores tem uma linha com defeito. Olhe a imagem, percorra o código e ache a linha. A "
             "sua cena espera como você a deixou.";
    case BugText::surprise:
      return "Surpreenda-me";
    case BugText::surprise_title:
      return "Uma surpresa";
    case BugText::number:
      return "Defeito {0}";
    case BugText::found:
      return "achado";
    case BugText::given_up:
      return "revelado";
    case BugText::tally:
      return "{0} de {1} achados";
    case BugText::banner:
      return "Este traçador tem um defeito";
    case BugText::banner_mended:
      return "O defeito está consertado";
    case BugText::seen:
      return "O que se vê";
    case BugText::task:
      return "O pixel {0} de SCREEN o mostra: o percurso está ali. Avance e clique no código a linha com defeito; ou "
             "deixe-a correr e tecle Enter.";
    case BugText::task_of_lesson:
      return "Clique no código a linha com defeito";
    case BugText::no_line_marked:
      return "Nenhuma linha marcada ainda.";
    case BugText::line_marked:
      return "Marcada: {0}";
    case BugText::mark:
      return "Marcar esta linha";
    case BugText::judge:
      return "É esta linha?";
    case BugText::give_up:
      return "Ver a cura";
    case BugText::right:
      return "Certo: {0}";
    case BugText::not_right:
      return "Não é esta linha: {0}, e foi o que fez.";
    case BugText::was:
      return "Era: {0}";
    case BugText::hint:
      return "Uma dica";
    case BugText::wrong:
      return "O que estava errado";
    case BugText::cure:
      return "A cura";
    case BugText::mend:
      return "Consertar";
    case BugText::break_again:
      return "Quebrar de novo";
    case BugText::other_rays_whole:
      return "Pontilhados na planta: os raios que um traçador sem o defeito forma para este pixel.";
    case BugText::other_rays_broken:
      return "Pontilhados na planta: os raios em que o defeito os transformou.";
    case BugText::all_bugs:
      return "Todos os defeitos";
    case BugText::leave:
      return "Voltar à minha cena";
  }
  return {};
}

namespace {

/// What is known about one fault.
struct Known {
  std::string_view symptom, hint, wrong, cure;
};

Known known(Fault fault) {
  switch (fault) {
    case Fault::shadow_ray_misaimed:
      return {"As sombras caem para o lado errado, e superfícies voltadas para a luz ficam escuras.",
              "Siga os raios de sombra até o fim. O que deveria estar lá?",
              "A linha tomou a posição da luz pela direção do raio. Ela aponta para a luz a partir da origem da planta "
              "e, de qualquer outro lugar, aponta para o lado.",
              "direção = luz − encontro: o caminho de um ponto a outro é a diferença dos dois."};
    case Fault::reflection_flipped:
      return {"Os espelhos não mostram nada do que está diante deles.",
              "Olhe um raio refletido onde ele deixa a superfície. De que lado ele segue?",
              "A linha somou a normal com o sinal errado: r = d − 2 cos θ n. Isso empurra o raio para dentro do corpo "
              "em vez de devolvê-lo.",
              "r = d + 2 cos θ n, onde n está voltada para o raio e cos θ = −d · n. Vire a normal para o raio antes de "
              "usá-la."};
    case Fault::refraction_inverted:
      return {
          "O que se vê através do vidro está no lugar errado.",
          "Siga um raio para dentro do vidro. Para que lado da direção antiga ele se dobra, e para qual deveria?",
          "A linha dividiu os índices ao contrário: n₂ / n₁. Dobrou a luz que entra no vidro como se ela saísse dele.",
          "sen θ₂ = (n₁ / n₂) sen θ₁, onde n₁ é do lado de onde vem o raio. Ao entrar no vidro ele se aproxima da "
          "normal."};
    case Fault::attenuation_forgotten:
      return {"Superfícies longe de uma luz são tão claras quanto as que estão perto.",
              "Cada raio vai para onde deve. Compare números: quanto traz uma luz a um encontro próximo e a um "
              "distante? (Equation, E)",
              "A linha somou cada luz inteira e nunca perguntou de que distância ela vinha.",
              "Uma luz conta L / (c + l r + q r²), onde r é o comprimento do seu raio de sombra."};
    case Fault::depth_not_counted:
      return {
          "Alguns pixels gastam muito mais raios do que o limite de profundidade deveria permitir.",
          "Observe DEPTH ao lado do título de SHADE, ou a pilha (K). Quando ele cresce e quando fica parado?",
          "A linha passou adiante o seu próprio DEPTH e esqueceu o + 1. O limite nunca foi alcançado; só uma parada de "
          "emergência terminou a recursão.",
          "Cada SHADE chamada recebe DEPTH + 1. Então o limite encerra o que os espelhos continuariam para sempre."};
    case Fault::epsilon_wrong_side:
      return {"Os espelhos estão baços: parecem mostrar só a si mesmos.",
              "Veja até onde chegam os raios refletidos e o que eles encontram.",
              "A linha começou o raio um fio abaixo da superfície. A primeira coisa que ele encontrou dali foi a "
              "superfície que acabara de deixar.",
              "Comece em encontro + ε n, onde n está voltada para o lado em que o raio segue. Com o outro sinal ele "
              "começa dentro."};
    case Fault::second_root_dropped:
      return {"O que se vê através de uma bola de vidro está errado, embora cada raio se dobre direito onde entra.",
              "Siga um raio dentro da bola. Por onde ele deveria ter saído?",
              "A linha olhou só a raiz mais próxima da equação. De dentro de uma esfera ela fica atrás do começo do "
              "raio, e por isso a saída nunca foi achada.",
              "Das duas raízes pegue a menor acima de 0: a primeira vinda de fora, a segunda vinda de dentro."};
    case Fault::epsilon_too_small:
      return {"Superfícies iluminadas estão salpicadas de pontos escuros.",
              "Ache um raio de sombra bloqueado onde nada está diante da luz. O que o bloqueia, e em que t?",
              "A linha começou o raio na própria superfície. O encontro é arredondado: aqui e ali ele cai logo abaixo "
              "da superfície, que então esconde a sua própria luz.",
              "Comece o raio acima da superfície, por mais do que o arredondamento erra. Os raios do Raywalk não "
              "precisam de ε: sabem que superfície deixam."};
  }
  return {};
}

}  // namespace

std::string_view portuguese(FaultTextOf of) {
  const Known all = known(of.fault);
  switch (of.id) {
    case FaultText::symptom:
      return all.symptom;
    case FaultText::hint:
      return all.hint;
    case FaultText::wrong:
      return all.wrong;
    case FaultText::cure:
      return all.cure;
  }
  return {};
}

std::string_view portuguese(DutyOf of) {
  switch (of.line) {
    case Line::for_each_pixel:
      return "ela toma um pixel depois do outro";
    case Line::form_primary_ray:
      return "ela mira de EYE pelo meio do pixel";
    case Line::find_closest_intersection:
      return "ela acha a coisa mais próxima no raio primário";
    case Line::if_intersect_something:
      return "ela pergunta se algo foi encontrado";
    case Line::shade_final:
      return "ela chama SHADE com DEPTH 1";
    case Line::put_final_shade:
      return "ela guarda a cor que recebe";
    case Line::form_shadow_ray:
      return "ela mira do encontro para a luz e começa logo acima da superfície";
    case Line::find_intersection:
      return "ela pergunta se algo está no raio de sombra";
    case Line::if_reflective:
      return "ela pergunta se o material espelha";
    case Line::form_reflect_ray:
      return "ela espelha o raio e começa logo acima da superfície";
    case Line::find_reflect_intersect:
      return "ela acha a coisa mais próxima no raio refletido";
    case Line::shade_reflect:
      return "ela chama SHADE com um DEPTH a mais";
    case Line::if_transparent:
      return "ela pergunta se o material deixa passar luz";
    case Line::form_refract_ray:
      return "ela dobra o raio pela lei de Snell";
    case Line::find_refract_intersect:
      return "ela acha a coisa mais próxima no raio refratado";
    case Line::shade_refract:
      return "ela chama SHADE com um DEPTH a mais";
    case Line::compute_rtnshade:
      return "ela soma o que trazem as luzes e os outros raios";
    case Line::path_for_each_pixel:
    case Line::path_form_primary_ray:
    case Line::follow_path:
    case Line::path_put_final_shade:
    case Line::while_ray:
    case Line::path_find_closest_intersection:
    case Line::if_intersect_nothing:
    case Line::add_background:
    case Line::add_emission:
    case Line::path_form_shadow_ray:
    case Line::path_find_intersection:
    case Line::add_light:
    case Line::choose_direction:
    case Line::if_path_survives:
    case Line::form_next_ray:
      break;  // paths are never broken
  }
  return {};
}

}  // namespace raywalk
